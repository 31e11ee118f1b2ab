#include "bench/forces/bswarm15_scalar.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace mayfly::bench {
namespace {

constexpr float kTiny = 1e-9F;  // a shorter vector has no direction

glm::vec3 unit(glm::vec3 v) {
  const float length = std::sqrt(glm::dot(v, v));
  return length < kTiny ? glm::vec3(0.0F) : v / length;
}

// Sums are of up to 200 000 unit vectors: in double, or the last digits of the mean would be the order's.
struct Zone {
  glm::dvec3 sum{0.0};
  int count = 0;

  void add(glm::vec3 v) {
    sum += glm::dvec3(v);
    ++count;
  }
  glm::vec3 mean(float weight) const {
    return count == 0 ? glm::vec3(0.0F) : glm::vec3(sum * (static_cast<double>(weight) / count));
  }
};

}  // namespace

glm::vec3 bswarm15_force(std::span<const glm::vec3> places, std::span<const glm::vec3> velocities,
                         std::size_t agent, const BSwarm15Parameters& parameters) {
  const glm::vec3 r = places[agent];
  const glm::vec3 v = velocities[agent];
  Zone repulsion;
  Zone alignment;
  Zone attraction;
  for (std::size_t other = 0; other < places.size(); ++other) {
    if (other == agent) {
      continue;
    }
    const glm::vec3 line = places[other] - r;
    const float distance = std::sqrt(glm::dot(line, line));
    if (distance > parameters.att_radius) {
      continue;
    }
    if (distance < parameters.rep_radius) {
      repulsion.add(-unit(line));
    } else if (distance < parameters.ali_radius) {
      alignment.add(unit(velocities[other] - v));
    } else {
      attraction.add(unit(line));
    }
  }
  const glm::vec3 to_food = parameters.food - r;
  const bool near_food = glm::dot(to_food, to_food) <= parameters.food_reach * parameters.food_reach;
  return repulsion.mean(parameters.rep_weight) + alignment.mean(parameters.ali_weight) +
         attraction.mean(parameters.att_weight) - parameters.friction * glm::length(v) * v +
         (near_food ? parameters.food_weight * unit(to_food) : glm::vec3(0.0F));
}

}  // namespace mayfly::bench
