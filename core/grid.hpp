// A regular grid of cubic cells over a box, the frame that every precomputed field shares.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

namespace mayfly {

// Axis-aligned box, metres, world frame (x east, y north, z up).
struct Box {
  glm::vec3 min{0.0F};
  glm::vec3 max{0.0F};

  bool contains(glm::vec3 p) const {
    return p.x >= min.x && p.y >= min.y && p.z >= min.z && p.x <= max.x && p.y <= max.y && p.z <= max.z;
  }
};

// Values live at cell centres: cell (i,j,k) is centred at origin + cell·(i+½, j+½, k+½), x fastest in memory.
struct Grid {
  glm::vec3 origin{0.0F};
  float cell = 1.0F;    // m, the side of a cell
  glm::ivec3 cells{0};  // how many along x, y, z

  std::size_t size() const {
    return static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) *
           static_cast<std::size_t>(cells.z);
  }
  std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(cells.x) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(k));
  }
  glm::vec3 center(int i, int j, int k) const {
    return origin +
           cell * (glm::vec3(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k)) + 0.5F);
  }
};

}  // namespace mayfly
