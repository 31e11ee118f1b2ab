#include "controller/governor/governor_config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "controller/governor/fence.hpp"
#include "controller/governor/reservation.hpp"

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

Result<void> check_motion(const GovernorLimits& limits) {
  if (!positive(limits.speed)) {
    return refuse("the governor's speed limit", fmt::format("{:g} m/s", limits.speed), "> 0 m/s");
  }
  if (!positive(limits.acceleration)) {
    return refuse("the governor's acceleration limit", fmt::format("{:g} m/s²", limits.acceleration),
                  "> 0 m/s²");
  }
  if (!positive(limits.braking) || limits.braking > limits.acceleration) {
    return refuse("the governor's braking", fmt::format("{:g} m/s²", limits.braking),
                  fmt::format("in (0, {:g}] m/s², the acceleration limit", limits.acceleration));
  }
  return {};
}

Result<void> check_body(const GovernorLimits& limits) {
  if (!not_negative(limits.radius) || !not_negative(limits.tube) || !not_negative(limits.response_time) ||
      !not_negative(limits.watchdog)) {
    return refuse("the governor's radius, tube, response time or watchdog",
                  fmt::format("{:g} m, {:g} m, {:g} s, {:g} s", limits.radius, limits.tube,
                              limits.response_time, limits.watchdog),
                  "finite, >= 0");
  }
  if (limits.latency < 0 || limits.latency > kMostLatency) {
    return refuse("the governor's latency", fmt::format("{} ticks", limits.latency),
                  fmt::format("0 to {} ticks", kMostLatency));
  }
  if (!std::isfinite(limits.downwash) || limits.downwash < 1.0F) {
    return refuse("the governor's downwash", fmt::format("{:g}", limits.downwash), ">= 1");
  }
  return {};
}

Result<void> check_separation(const GovernorGroup& group) {
  const GovernorLimits& limits = group.limits;
  const float least = 2.0F * (limits.radius + limits.tube);
  if (group.separation <= 0.0F) {
    return {};
  }
  if (group.separation < least * (1.0F - 1e-6F)) {  // sums of decimal fractions are rounded
    return refuse(
        "the separation is below what the governor keeps",
        fmt::format("separation = {:g} m", group.separation),
        fmt::format(">= 2 · (radius {:g} + tube {:g}) = {:g} m", limits.radius, limits.tube, least));
  }
  const float unheard = limits.speed * limits.watchdog;
  if (unheard > group.separation) {
    return refuse("a robot that hears nothing flies on for more than the separation",
                  fmt::format("speed {:g} · watchdog {:g} = {:g} m", limits.speed, limits.watchdog, unheard),
                  fmt::format("<= separation = {:g} m", group.separation));
  }
  return {};
}

Result<void> check_box(const Box& fence, const GovernorLimits& limits, double period) {
  const double body = 2.0 * (static_cast<double>(limits.radius) + static_cast<double>(limits.tube));
  const double stop = stopping_distance(limits.speed, {limits.braking, period, limits.watchdog});
  for (int axis = 0; axis < 3; ++axis) {
    const double side = static_cast<double>(fence.max[axis]) - static_cast<double>(fence.min[axis]);
    if (!std::isfinite(side) || !(side > body)) {
      return refuse("the fence has no room for a body", fmt::format("{:g} m along {}", side, "xyz"[axis]),
                    fmt::format("> 2 · (radius + tube) = {:g} m", body));
    }
    if (side < body + stop) {
      return refuse("the fence is smaller than a stopping distance",
                    fmt::format("{:g} m along {}", side, "xyz"[axis]),
                    fmt::format(">= 2 · (radius + tube) + |v|·watchdog + |v|²/(2·braking) + braking·T²/8 = "
                                "{:g} m, or a lower speed limit",
                                body + stop));
    }
  }
  return {};
}

// Whether the half-spaces leave anything of the box: from its middle, again and again to the nearest point
// that the worst of them allows.
Result<void> check_half_spaces(const GovernorConfig& config, double kept) {
  for (const HalfSpace& half_space : config.half_spaces) {
    const double length = length3(glm::dvec3(half_space.normal));
    if (!std::isfinite(length) || !(length > 0.0) || !std::isfinite(half_space.offset)) {
      return refuse("a half-space of the fence has no direction", "", "a normal that is not zero");
    }
  }
  const Fence fence(config.fence, config.half_spaces);
  const double room = fence.room_from(0.5 * (glm::dvec3(config.fence.min) + glm::dvec3(config.fence.max)));
  if (!(room > kept)) {
    return refuse("the fence's half-spaces leave no room for a body",
                  fmt::format("at most {:.3g} m to the border, wherever one is", room),
                  fmt::format("> radius + tube = {:g} m", kept));
  }
  return {};
}

Result<void> check_group(const GovernorConfig& config, const GovernorGroup& group) {
  const GovernorLimits& limits = group.limits;
  auto ok = check_motion(limits).and_then([&] { return check_body(limits); });
  if (!ok || !group.enabled) {
    return ok;
  }
  const double kept = static_cast<double>(limits.radius) + static_cast<double>(limits.tube);
  return check_box(config.fence, limits, to_seconds(config.period))
      .and_then([&] { return check_separation(group); })
      .and_then([&] { return check_half_spaces(config, kept); });
}

}  // namespace

Result<void> check(const GovernorConfig& config) {
  if (config.period <= Time{0}) {
    return refuse("the governor's period", fmt::format("{:g} s", to_seconds(config.period)), "> 0 s");
  }
  std::size_t next = 0;
  for (const GovernorGroup& group : config.groups) {
    if (group.first != next) {
      return refuse("the governor's groups leave a gap or overlap",
                    fmt::format("a group that begins at {}", group.first), fmt::format("{}", next));
    }
    next += group.count;
    if (auto ok = check_group(config, group); !ok) {
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
