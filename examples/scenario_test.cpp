// A test of your own scenario: flown on simulated robots and a virtual clock, and held to what you need of
// it.
#include <cstdio>
#include "controller/scenario/load.hpp"
#include "simulate/fly_simulated.hpp"

constexpr auto kScenario = R"(
mayfly: 1
duration: 20
world:
  bounds: {min: [0, 0, 0], max: [24, 12, 8]}
  cell: 0.5
  obstacles: [{cylinder: {from: [12, 6, 0], to: [12, 6, 8], radius: 2}}]
  goals: {exit: {box: {min: [19, 2, 2], max: [23, 10, 6]}}}
swarms:
  - {name: flies, count: 20, start: {box: {min: [1, 2, 2], max: [5, 10, 6]}}, goal: exit, noise: {scale: 2}}
hal: {sim: {kind: sim, plant: velocity_lag}}
)";

int refuse(const std::vector<mayfly::Error>& errors) {
  for (const mayfly::Error& error : errors) std::puts(to_string(error).c_str());
  return 2;
}

int main() {
  const mayfly::Override more = *mayfly::parse_override("swarms.flies.count=60");  // as --set does
  const auto scenario = mayfly::load_scenario_text(kScenario, "my_scenario.yaml", {&more, 1});
  if (!scenario) return refuse(scenario.error());
  const auto flown = mayfly::simulate::fly_simulated(*scenario);
  if (!flown) return refuse(flown.error());
  std::printf("%g reached, %g m apart at least\n", *flown->reached_fraction, *flown->min_separation_m);
  return flown->reached_fraction == 1.0 && flown->penetrations == 0U && flown->collisions == 0U ? 0 : 1;
}
