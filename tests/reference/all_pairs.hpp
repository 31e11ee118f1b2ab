// The smallest distance of two agents and the pairs that touch, by looking at every pair.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <utility>

namespace mayfly::reference {

class AllPairs {
 public:
  void observe(std::span<const float> x, std::span<const float> y, std::span<const float> z,
               std::span<const float> radii) {
    std::set<std::pair<std::size_t, std::size_t>> touching;
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = i + 1; j < x.size(); ++j) {
        const double dx = double{x[i]} - x[j], dy = double{y[i]} - y[j], dz = double{z[i]} - z[j];
        const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
        if (!std::isfinite(distance)) {
          continue;
        }
        min_distance = std::fmin(min_distance, distance);
        if (distance < double{radii[i]} + radii[j]) {
          touching.emplace(i, j);
          encounters += last_.count({i, j}) == 0 ? 1U : 0U;
        }
      }
    }
    last_ = touching;
  }

  double min_distance = std::numeric_limits<double>::infinity();
  std::uint64_t encounters = 0;

 private:
  std::set<std::pair<std::size_t, std::size_t>> last_;
};

}  // namespace mayfly::reference
