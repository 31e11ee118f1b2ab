#include "controller/flight/start_check.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "controller/flight/flight_config.hpp"
#include "controller/flight/motion.hpp"
#include "controller/governor/governor.hpp"

namespace mayfly {
namespace {

// Of the agent, and how it is numbered in it.
std::pair<const SwarmSpec*, std::size_t> swarm_of(const Scenario& scenario, std::size_t agent) {
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    if (agent < count) {
      return {&swarm, agent};
    }
    agent -= count;
  }
  return {&scenario.swarms.back(), agent};
}

}  // namespace

Result<void> check_start(const Scenario& scenario, const World& world, std::span<const glm::vec3> places) {
  const auto governed = std::find_if(scenario.swarms.begin(), scenario.swarms.end(),
                                     [](const SwarmSpec& swarm) { return swarm.governor; });
  if (governed == scenario.swarms.end()) {
    return {};
  }
  const Motion motion(scenario);
  auto governor = Governor::make(governor_config(scenario, world, motion));
  if (!governor) {
    governor.error().place = governed->start_place;
    return fail(std::move(governor.error()));
  }
  std::vector<float> x, y, z;
  for (const glm::vec3 place : places) {
    x.push_back(place.x);
    y.push_back(place.y);
    z.push_back(place.z);
  }
  const std::vector<float> rest(places.size(), 0.0F);
  const std::vector<std::uint8_t> known(places.size(), 1);
  const auto name = [&](std::size_t agent) {
    const auto [swarm, number] = swarm_of(scenario, agent);
    return swarm->name + "_" + std::to_string(number);
  };
  auto admitted = governor->admit({x, y, z, rest, rest, rest, known}, name);
  if (!admitted) {
    admitted.error().error.place = swarm_of(scenario, admitted.error().agent).first->start_place;
    return fail(std::move(admitted.error().error));
  }
  return {};
}

}  // namespace mayfly
