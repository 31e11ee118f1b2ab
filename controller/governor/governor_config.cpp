#include "controller/governor/governor_config.hpp"

#include <cmath>
#include <string>

namespace mayfly {
namespace {

bool positive(float value) {
  return std::isfinite(value) && value > 0.0F;
}
bool not_negative(float value) {
  return std::isfinite(value) && value >= 0.0F;
}

Result<void> refuse(std::string message, std::string found, std::string wanted) {
  return fail({.message = std::move(message), .found = std::move(found), .wanted = std::move(wanted)});
}

Result<void> check_limits(const GovernorLimits& limits) {
  if (!positive(limits.speed)) {
    return refuse("the governor's speed limit", std::to_string(limits.speed) + " m/s", "> 0 m/s");
  }
  if (!positive(limits.acceleration)) {
    return refuse("the governor's acceleration limit", std::to_string(limits.acceleration) + " m/s²",
                  "> 0 m/s²");
  }
  if (!positive(limits.braking) || limits.braking > limits.acceleration) {
    return refuse("the governor's braking", std::to_string(limits.braking) + " m/s²",
                  "in (0, " + std::to_string(limits.acceleration) + "] m/s², the acceleration limit");
  }
  if (!not_negative(limits.radius) || !not_negative(limits.tube) || !not_negative(limits.response_time)) {
    return refuse("the governor's radius, tube or response time",
                  std::to_string(limits.radius) + " m, " + std::to_string(limits.tube) + " m, " +
                      std::to_string(limits.response_time) + " s",
                  "finite, >= 0");
  }
  return {};
}

Result<void> check_fence(const Box& fence, const GovernorLimits& limits) {
  const float margin = 2.0F * (limits.radius + limits.tube);
  for (int axis = 0; axis < 3; ++axis) {
    const float side = fence.max[axis] - fence.min[axis];
    if (!std::isfinite(side) || !(side > margin)) {
      return refuse("the fence has no room for a body", std::to_string(side) + " m along " + "xyz"[axis],
                    "> 2 · (radius + tube) = " + std::to_string(margin) + " m");
    }
  }
  return {};
}

}  // namespace

Result<void> check(const GovernorConfig& config) {
  if (config.period <= Time{0}) {
    return refuse("the governor's period", std::to_string(to_seconds(config.period)) + " s", "> 0 s");
  }
  std::size_t next = 0;
  for (const GovernorGroup& group : config.groups) {
    if (group.first != next) {
      return refuse("the governor's groups leave a gap or overlap",
                    "a group that begins at " + std::to_string(group.first), std::to_string(next));
    }
    next += group.count;
    if (auto ok = check_limits(group.limits); !ok) {
      return ok;
    }
    if (auto ok = check_fence(config.fence, group.limits); group.enabled && !ok) {
      return ok;
    }
  }
  const Grid& grid = config.obstacles.sampled.grid;
  if (!config.obstacles.sampled.empty() &&
      (!positive(grid.cell) || grid.cells.x < 1 || grid.cells.y < 1 || grid.cells.z < 1)) {
    return refuse("the governor's distance field", "no cells", "a grid");
  }
  return {};
}

}  // namespace mayfly
