// The baseline: the interaction forces of BSwarm15 §4 as the paper has them, in plain scalar C++: one agent
// after the other, all others looked at. Nothing of the product is in it, and nothing of it is in the
// product.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace mayfly::bench {

// Zones are radii, m; weights m/s².
struct BSwarm15Parameters {
  float friction = 0.0F;  // 1/m
  float rep_weight = 0.0F, ali_weight = 0.0F, att_weight = 0.0F;
  float rep_radius = 0.0F, ali_radius = 0.0F, att_radius = 0.0F;
  // Food: everybody within `food_reach` m of it is drawn to it, m/s².
  glm::vec3 food{0.0F};
  float food_weight = 0.0F, food_reach = 0.0F;
};

// F_int + F_fric + F_res of one agent, m/s².
glm::vec3 bswarm15_force(std::span<const glm::vec3> places, std::span<const glm::vec3> velocities,
                         std::size_t agent, const BSwarm15Parameters& parameters);

}  // namespace mayfly::bench
