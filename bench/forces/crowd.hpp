// Swarms in open space, for the rows of `mayfly bench forces`: no walls, no files.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "bench/common/ticks.hpp"
#include "controller/engine/engine.hpp"

namespace mayfly::bench {

struct Crowd {
  std::vector<SwarmModel> swarms;
  std::vector<glm::vec3> places, velocities;  // m, m/s

  Flock flock() const { return {.swarms = swarms, .places = places, .velocities = velocities}; }
};

// Uniform in a box about the origin, m; the same for the same seed.
std::vector<glm::vec3> strewn_in_box(std::size_t agents, glm::vec3 size, std::uint32_t seed = 7);
// Uniform in a ball about the origin.
std::vector<glm::vec3> strewn_in_ball(std::size_t agents, float radius, std::uint32_t seed = 7);

// One swarm that flies by `motor` from `places` on at random velocities up to `speed` m/s, in bounds far off.
// No noise, no minimum distances, no avoidance: what a row measures is set on its model.
Crowd make_crowd(Motor motor, std::vector<glm::vec3> places, float speed);

// BSwarm15's table, column aggregation 3000: a cloud so small that each sees all others.
Crowd make_midges(std::size_t agents);
// Column locusts: 24 × 5 × 0.5 m, and a crop 25 m ahead of it.
Crowd make_locusts(std::size_t agents);

}  // namespace mayfly::bench
