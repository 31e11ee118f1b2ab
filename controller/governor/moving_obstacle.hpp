// An obstacle that moves without turning, as the governor and the metrics see it.
#pragma once

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "controller/governor/distance_view.hpp"
#include "core/grid.hpp"

namespace mayfly {

struct DistanceBounds {  // m: low ≤ φ ≤ high
  double low = 0.0;
  double high = 0.0;
};

// φ is a float of a point that is one: what is exact is so up to this share of both.
inline constexpr double kDistanceRounding = 2e-7;

// Exact but for rounding.
inline DistanceBounds around(double phi, glm::dvec3 p) noexcept {
  const double rounding = kDistanceRounding * (1.0 + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
  return {phi - rounding, phi + rounding};
}

// Everything is told in a frame that the obstacle rests in: only the way between that frame and the world
// changes.
struct MovingObstacle {
  Box bounds;                               // m: it lies within
  DistanceView sampled{};                   // φ around it; empty: `exact` is cheap enough to be asked always
  std::function<float(glm::vec3)> exact{};  // φ in m; allocates, blocks and throws nothing
  const glm::vec3* displacement = nullptr;  // m, where it is now: whoever flies keeps it at the tick's time

  // p: m, in the world.
  DistanceBounds bounds_at(glm::dvec3 p) const noexcept {
    const glm::dvec3 q = p - glm::dvec3(*displacement);
    const auto low = glm::dvec3(bounds.min);
    const auto high = glm::dvec3(bounds.max);
    const double to_box = glm::length(glm::max(glm::max(low - q, q - high), glm::dvec3(0.0)));
    const double across = glm::length(high - low);
    if (to_box > across) {
      return {to_box, to_box + across};
    }
    if (sampled.empty()) {
      return sharpest_at(p);
    }
    const DistanceView::Sample s = sampled.sample(q.x, q.y, q.z);
    return {std::fmax(s.value - s.error, to_box), s.value + s.error};
  }

  DistanceBounds sharpest_at(glm::dvec3 p) const noexcept {
    const glm::dvec3 q = p - glm::dvec3(*displacement);
    return around(exact(glm::vec3(q)), glm::abs(p) + glm::abs(q));
  }
};

}  // namespace mayfly
