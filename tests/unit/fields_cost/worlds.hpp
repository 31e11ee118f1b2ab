// Small worlds whose distances are known in closed form.
#pragma once

#include <algorithm>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

#include "fields/cost_field.hpp"

namespace mayfly::fields::worlds {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Phi = std::function<float(glm::vec3)>;

inline float box_distance(glm::vec3 p, const Box& box) {
  const glm::vec3 q = glm::max(box.min - p, p - box.max);
  return glm::length(glm::max(q, glm::vec3(0.0F))) + std::min(std::max({q.x, q.y, q.z}), 0.0F);
}

inline Phi box(glm::vec3 min, glm::vec3 max) {
  return [=](glm::vec3 p) { return box_distance(p, {min, max}); };
}
inline Phi sphere(glm::vec3 center, float radius) {
  return [=](glm::vec3 p) { return glm::distance(p, center) - radius; };
}
inline Phi nothing() {
  return [](glm::vec3) { return kNoObstacle; };
}
inline Phi unite(std::vector<Phi> parts) {
  return [=](glm::vec3 p) {
    float least = kNoObstacle;
    for (const Phi& part : parts) {
      least = std::min(least, part(p));
    }
    return least;
  };
}

inline std::vector<float> sample(const Grid& grid, const Phi& phi) {
  std::vector<float> values(grid.size());
  for (int k = 0; k < grid.cells.z; ++k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        values[grid.index(i, j, k)] = phi(grid.center(i, j, k));
      }
    }
  }
  return values;
}

inline DistanceField obstacles(const Grid& grid, const Phi& phi) {
  return {grid, sample(grid, phi)};
}
inline GoalDistance goal(const Grid& grid, const Phi& phi) {
  return {grid, sample(grid, phi), std::nullopt, {}};
}

inline Grid cube(int n, float side) {
  return {glm::vec3(0.0F), side / static_cast<float>(n), glm::ivec3(n)};
}

// Boxes at random, some thinner than a cell.
inline std::vector<Phi> random_boxes(std::mt19937& random, float world, int count) {
  std::uniform_real_distribution<float> place(0.0F, world);
  std::uniform_real_distribution<float> extent(0.05F, 0.35F * world);
  std::vector<Phi> boxes;
  for (int n = 0; n < count; ++n) {
    const glm::vec3 min(place(random), place(random), place(random));
    glm::vec3 size(extent(random), extent(random), extent(random));
    size[n % 3] *= 0.2F;
    boxes.push_back(box(min, min + size));
  }
  return boxes;
}

}  // namespace mayfly::fields::worlds
