// Whether the promise may begin.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "controller/governor/governor.hpp"

namespace mayfly {
namespace {

Result<void> refuse(std::string message, std::string found, std::string wanted) {
  return fail({.message = std::move(message), .found = std::move(found), .wanted = std::move(wanted)});
}

std::string numbered(std::size_t agent) {
  return fmt::format("robot {}", agent);
}

}  // namespace

tl::expected<void, NotAdmitted> Governor::admit(const GovernorState& state, const AgentName& name) const {
  if (!columns_fit(agents(), state)) {
    return tl::unexpected(NotAdmitted{
        0, {.message = "the start state has too few rows", .wanted = fmt::format("{} robots", agents())}});
  }
  const AgentName called = name ? name : numbered;
  Governor trial = *this;
  trial.fleet_.settle(state, to_seconds(config_.period));
  for (std::size_t i = 0; i < agents(); ++i) {
    if (!trial.fleet_.group_of(i).spec.enabled) {
      continue;
    }
    auto ok = trial.admit_robot(i, called).and_then([&] { return trial.admit_pairs(i, called); });
    if (!ok) {
      return tl::unexpected(NotAdmitted{i, std::move(ok.error())});
    }
  }
  return {};
}

Result<void> Governor::admit_robot(std::size_t i, const AgentName& name) {
  const FleetRobot& robot = fleet_.robot(i);
  const GroupModel& group = fleet_.group_of(i);
  if (!is_flown(robot.authority)) {
    return {};
  }
  if (!robot.reference.known()) {
    return refuse(fmt::format("nobody knows where {} is", name(i)), "", "an estimate of its place");
  }
  for (const glm::dvec3& point : robot.braking.points()) {
    if (fence_.depth(point) < group.kept) {
      return refuse(fmt::format("{} starts where it cannot stop inside the fence", name(i)),
                    fmt::format("{:.4f} m from where it would rest to the border", fence_.depth(point)),
                    fmt::format(">= radius + tube + rounding = {:.4f} m", group.kept));
    }
  }
  const Capsule& capsule = fleet_.claim(i).capsule;
  if (!config_.obstacles.empty() && !clear_of_obstacles(capsule, config_.obstacles, {group.kept, 0.0})) {
    const double nearest = std::min(config_.obstacles.sharpest_bounds(capsule.a).low,
                                    config_.obstacles.sharpest_bounds(capsule.b).low);
    return refuse(fmt::format("{} starts too near to an obstacle", name(i)),
                  fmt::format("{:.4f} m", nearest - capsule.radius),
                  fmt::format(">= radius + tube + rounding = {:.4f} m", group.kept));
  }
  return {};
}

Result<void> Governor::admit_pairs(std::size_t i, const AgentName& name) {
  const Claim& mine = fleet_.claim(i);
  if (!mine.present) {
    return {};
  }
  for (const std::uint32_t j : fleet_.near(i)) {
    const Claim& other = fleet_.claim(j);
    const double rest_time = fleet_.group_of(i).rest_time(length3(glm::dvec3(fleet_.robot(i).sent)));
    if (keeps_distance(mine, other, rest_time)) {
      continue;
    }
    const double scale = std::min(mine.scale, other.scale);
    const double axes = length3(nearest_way(flattened(mine.capsule, scale), flattened(other.capsule, scale)));
    const double found = axes - mine.capsule.radius - other.capsule.radius - reach_of(other, rest_time);
    return refuse(fmt::format("{} and {} start too near to each other", name(std::min<std::size_t>(i, j)),
                              name(std::max<std::size_t>(i, j))),
                  fmt::format("{:.4f} m between where they may get to", found),
                  fmt::format(">= two radii + two tubes + rounding = {:.4f} m{}", mine.kept + other.kept,
                              scale < 1.0 ? fmt::format(", heights divided by {:g}", 1.0 / scale) : ""));
  }
  return {};
}

}  // namespace mayfly
