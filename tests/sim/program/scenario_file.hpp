// A small world for whole flights: two boxes with a way between them, forty agents.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace mayfly::test {

inline constexpr auto kSmallScenario = R"(mayfly: 1
name: small
seed: 5
duration: 3
world:
  bounds: {min: [0, 0, 0], max: [20, 30, 12]}
  cell: 1.0
  obstacles:
    - {box: {min: [0, 12, 0], max: [8, 16, 12]}}
    - {box: {min: [12, 12, 0], max: [20, 16, 12]}}
  goals:
    exit: {box: {min: [4, 22, 2], max: [16, 28, 10]}}
swarms:
  - name: flies
    count: 40
    start: {box: {min: [4, 2, 2], max: [16, 8, 10]}}
    goal: exit
    noise: {kind: curl, scale: 2.0, gain: 0.3}
    cruise_speed: 1.5
    limits: {speed: 3, acceleration: 10, separation: 0.2}
    radius: 0.05
    robots: sim
control: {rate: 100}
hal:
  sim: {kind: sim, plant: velocity_lag, time_constant: 0.1}
expect:
  - penetrations: "== 0"
)";

inline std::string write_small_scenario(const std::filesystem::path& folder) {
  const auto file = folder / "small.yaml";
  std::ofstream(file) << kSmallScenario;
  return file.string();
}

}  // namespace mayfly::test
