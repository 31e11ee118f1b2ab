#include "controller/governor/fence.hpp"

#include <limits>

namespace mayfly {

Fence::Fence(const Box& box, const std::vector<HalfSpace>& half_spaces) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    planes_.push_back({normal, box.max[axis]});
    planes_.push_back({-normal, -static_cast<double>(box.min[axis])});
  }
  for (const HalfSpace& half_space : half_spaces) {
    const glm::dvec3 normal(half_space.normal);
    planes_.push_back({normal / length3(normal), half_space.offset / length3(normal)});
  }
}

bool Fence::holds(const Hull& wanted, const Hull& braking, double kept) const noexcept {
  for (const Plane& plane : planes_) {
    const double most = -wanted.least_along(-plane.normal);
    if (most > plane.offset - kept && most > -braking.least_along(-plane.normal)) {
      return false;
    }
  }
  return true;
}

// Away from the nearest plane, by ever smaller steps (a subgradient method).
double Fence::room_from(glm::dvec3 place) const noexcept {
  constexpr int kSteps = 2000;
  double step = 0.25 * (planes_[0].offset + planes_[1].offset);  // the box's first side
  double best = depth(place);
  for (int n = 0; n < kSteps; ++n) {
    const Plane* nearest = &planes_.front();
    for (const Plane& plane : planes_) {
      const bool nearer =
          plane.offset - dot3(plane.normal, place) < nearest->offset - dot3(nearest->normal, place);
      nearest = nearer ? &plane : nearest;
    }
    place -= step * nearest->normal;
    step *= 0.995;
    best = std::max(best, depth(place));
  }
  return best;
}

double Fence::depth(glm::dvec3 place) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes_) {
    least = std::min(least, plane.offset - dot3(plane.normal, place));
  }
  return least;
}

}  // namespace mayfly
