#include "controller/planner/plan.hpp"

#include <algorithm>

namespace mayfly {
namespace {

void copy(std::span<const float> x, std::span<const float> y, std::span<const float> z,
          Columns3& to) noexcept {
  std::copy_n(x.begin(), to.x.size(), to.x.begin());
  std::copy_n(y.begin(), to.y.size(), to.y.begin());
  std::copy_n(z.begin(), to.z.size(), to.z.begin());
}

}  // namespace

void SwarmCopy::copy(const SwarmView& from) noexcept {
  time_s = from.time_s;
  mayfly::copy(from.x, from.y, from.z, position);
  mayfly::copy(from.vx, from.vy, from.vz, velocity);
  mayfly::copy(from.told_x, from.told_y, from.told_z, told);
}

SwarmView SwarmCopy::view() const noexcept {
  return {time_s,     position.x, position.y, position.z, velocity.x,
          velocity.y, velocity.z, told.x,     told.y,     told.z};
}

}  // namespace mayfly
