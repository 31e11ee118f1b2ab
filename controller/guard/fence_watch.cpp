#include "controller/guard/fence_watch.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace mayfly {
namespace {

// Of a radius, and m: what rounding of positions to float can shift in a world of a kilometre.
constexpr double kRounding = 1e-5;
constexpr double kShift = 1e-4;

}  // namespace

FenceWatch::FenceWatch(const Box& box, const std::vector<HalfSpace>& half_spaces) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 outwards(0.0);
    outwards[axis] = 1.0;
    sides_.push_back({outwards, box.max[axis]});
    sides_.push_back({-outwards, -static_cast<double>(box.min[axis])});
  }
  for (const HalfSpace& half_space : half_spaces) {
    const double length = glm::length(glm::dvec3(half_space.normal));
    sides_.push_back({glm::dvec3(half_space.normal) / length, half_space.offset / length});
  }
}

bool FenceWatch::is_left_by(const StoppingPath& path) const noexcept {
  const double kept = path.radius * (1.0 - kRounding) - kShift;
  return std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
    const double most = std::max(side.distance - kept, glm::dot(side.outwards, path.from) + kShift);
    return glm::dot(side.outwards, path.to) > most;
  });
}

}  // namespace mayfly
