// Small scenarios made by hand, without a file, and their worlds.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "controller/flight/world.hpp"

namespace mayfly::test {

inline fields::Shape box(glm::vec3 min, glm::vec3 max) {
  return fields::BoxShape{{min, max}};
}

// An empty hall of 12 m × 20 m × 12 m, cells of 1 m; one swarm flies along +y into a goal of 8 m × 6 m × 8 m.
inline Scenario hall(int agents) {
  Scenario scenario;
  scenario.name = "hall";
  scenario.seed = 5;
  scenario.duration = 0.2;
  scenario.world.bounds = {{0, 0, 0}, {12, 20, 12}};
  scenario.world.goals = {{"exit", box({2, 12, 2}, {10, 18, 10}), {"hall.yaml", 8, 5}}};
  SwarmSpec swarm;
  swarm.name = "flies";
  swarm.count = agents;
  swarm.start = box({2, 1, 2}, {10, 5, 10});
  swarm.goal = "exit";
  swarm.robots = "sim";
  swarm.start_place = {"hall.yaml", 12, 7};
  scenario.swarms = {swarm};
  scenario.hals = {{"sim", {}}};
  return scenario;
}

// The same with a wall from y = 7 m to 9 m; with a gap of 4 m in the middle of it, or tight.
inline Scenario walled_hall(int agents, bool with_gap = true) {
  Scenario scenario = hall(agents);
  if (with_gap) {
    scenario.world.obstacles = {{box({-1, 7, -1}, {4, 9, 13}), {"hall.yaml", 5, 5}},
                                {box({8, 7, -1}, {13, 9, 13}), {"hall.yaml", 6, 5}}};
  } else {
    scenario.world.obstacles = {{box({-1, 7, -1}, {13, 9, 13}), {"hall.yaml", 5, 5}}};
  }
  return scenario;
}

inline std::string all_text(const std::vector<Error>& errors) {
  std::string text;
  for (const Error& error : errors) {
    text += to_string(error) + "\n";
  }
  return text;
}

inline World world_of(const Scenario& scenario) {
  auto world = build_world(scenario, 1, {});
  if (!world) {
    ADD_FAILURE() << all_text(world.error());
    std::abort();
  }
  return std::move(*world);
}

// Of all pairs; huge where there are fewer than two.
inline float smallest_distance(const std::vector<glm::vec3>& places) {
  float least = 1e30F;
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const glm::vec3 d = places[a] - places[b];
      least = std::min(least, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    }
  }
  return least;
}

}  // namespace mayfly::test
