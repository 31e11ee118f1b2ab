// Who is near whom: points in cubic cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

namespace mayfly::bench {

class Neighbours {
 public:
  // For questions of up to `reach` (m). `points` must outlive it.
  Neighbours(std::span<const glm::vec3> points, float reach) : points_(points), cell_(reach) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      order_.emplace_back(key_of(cell_of(points[p])), p);
    }
    std::sort(order_.begin(), order_.end());
  }

  // visit(point, squared distance) for all nearer than `within` ≤ reach, the one that asks included.
  template <class Visit>
  void for_each(glm::vec3 from, float within, Visit visit) const {
    const glm::ivec3 c = cell_of(from);
    for (int row = 0; row < 9; ++row) {  // of three cells along x, which follow each other
      const glm::ivec3 first = c + glm::ivec3(-1, row % 3 - 1, row / 3 - 1);
      const std::uint64_t last = key_of(first + glm::ivec3(2, 0, 0));
      const auto begin =
          std::lower_bound(order_.begin(), order_.end(), std::pair(key_of(first), std::size_t{0}));
      for (auto entry = begin; entry != order_.end() && entry->first <= last; ++entry) {
        const glm::vec3 line = points_[entry->second] - from;
        const float distance2 = glm::dot(line, line);
        if (distance2 < within * within) {
          visit(entry->second, distance2);
        }
      }
    }
  }

 private:
  glm::ivec3 cell_of(glm::vec3 p) const {
    const glm::vec3 c = p / cell_;
    return {static_cast<int>(std::floor(c.x)), static_cast<int>(std::floor(c.y)),
            static_cast<int>(std::floor(c.z))};
  }
  static std::uint64_t key_of(glm::ivec3 c) {
    constexpr std::int64_t kHalf = 1 << 20;
    const auto part = [](int v) { return static_cast<std::uint64_t>(v + kHalf); };
    return part(c.x) | part(c.y) << 21U | part(c.z) << 42U;
  }

  std::span<const glm::vec3> points_;
  float cell_;
  std::vector<std::pair<std::uint64_t, std::size_t>> order_;  // cell, point
};

}  // namespace mayfly::bench
