// How near obstacles are: sampled fields where they are enough, exact distances where they are not.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "controller/governor/distance_view.hpp"
#include "controller/governor/moving_obstacle.hpp"

namespace mayfly {

struct ObstacleView {
  DistanceView sampled;  // of what stands still; empty: nothing does
  // φ in m at a point, of what stands still; allocates, blocks and throws nothing. Asked only where the
  // sampled field cannot decide. Without it, robots keep away from obstacles by the sampled field's error
  // bound as well, up to √¾ of a cell.
  std::function<float(glm::vec3)> exact{};
  std::vector<MovingObstacle> moving{};

  bool empty() const { return sampled.empty() && moving.empty(); }

  using Bounds = DistanceBounds;

  // Infinite where there are no obstacles.
  Bounds bounds(glm::dvec3 p) const noexcept {
    Bounds nearest = bounds_of_still(p);
    for (const MovingObstacle& obstacle : moving) {
      nearest = nearer(nearest, obstacle.bounds_at(p));
    }
    return nearest;
  }

  Bounds sharpest_bounds(glm::dvec3 p) const {
    Bounds nearest =
        exact && !sampled.empty() ? around(exact(glm::vec3(p)), glm::abs(p)) : bounds_of_still(p);
    for (const MovingObstacle& obstacle : moving) {
      const Bounds rough = obstacle.bounds_at(p);
      if (rough.low < nearest.high) {
        nearest = nearer(nearest, obstacle.sharpest_at(p));
      }
    }
    return nearest;
  }

 private:
  Bounds bounds_of_still(glm::dvec3 p) const noexcept {
    if (sampled.empty()) {
      return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    const DistanceView::Sample s = sampled.sample(p.x, p.y, p.z);
    return {s.value - s.error, s.value + s.error};
  }
  // Of a union.
  static Bounds nearer(Bounds a, Bounds b) noexcept {
    return {std::fmin(a.low, b.low), std::fmin(a.high, b.high)};
  }
};

}  // namespace mayfly
