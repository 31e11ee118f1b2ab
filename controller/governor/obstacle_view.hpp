// How near obstacles are: the sampled field where it is enough, the exact distance where it is not.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "controller/governor/distance_view.hpp"

namespace mayfly {

struct ObstacleView {
  DistanceView sampled;  // empty: there are no obstacles
  // φ in m at a point; allocates, blocks and throws nothing. Asked only where the sampled field cannot
  // decide. Without it, robots keep away from obstacles by the sampled field's error bound as well, up to √¾
  // of a cell.
  std::function<float(glm::vec3)> exact{};

  bool empty() const { return sampled.empty(); }

  struct Bounds {
    double low = 0.0;  // m: low ≤ φ ≤ high
    double high = 0.0;
  };

  Bounds bounds(glm::dvec3 p) const noexcept {
    const DistanceView::Sample s = sampled.sample(p.x, p.y, p.z);
    return {s.value - s.error, s.value + s.error};
  }

  Bounds sharpest_bounds(glm::dvec3 p) const {
    if (!exact) {
      return bounds(p);
    }
    const double phi = exact(glm::vec3(p));
    const double rounding = kRounding * (1.0 + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
    return {phi - rounding, phi + rounding};
  }

 private:
  static constexpr double kRounding = 2e-7;  // of the point and of φ, which are floats
};

}  // namespace mayfly
