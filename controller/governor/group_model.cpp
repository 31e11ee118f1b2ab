#include "controller/governor/group_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/governor/margins.hpp"

namespace mayfly {
namespace {

double largest_coordinate(const Box& box) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::fabs(static_cast<double>(box.min[axis])),
                        std::fabs(static_cast<double>(box.max[axis]))});
  }
  return largest;
}

}  // namespace

double GroupModel::rest_time(double speed) const {
  return braking.period + braking.watchdog + speed / braking.deceleration;
}

double GroupModel::rest_time_unheard(double speed) const {
  return rest_time(speed) + 3.0 * model.response_time;
}

double GroupModel::reach(double speed, double tail) const {
  const double next = std::max(speed, std::min(speed + change_limit, static_cast<double>(spec.limits.speed)));
  return tail + braking.period * next + stopping_distance(next, braking) + most_nudge;
}

double GroupModel::usual_reach() const {
  const double speed = spec.limits.speed;
  return reach(speed, speed * (model.response_time + spec.limits.latency * braking.period));
}

GroupModel make_group_model(const GovernorGroup& spec, const GovernorConfig& config) {
  const GovernorLimits& limits = spec.limits;
  const double period = to_seconds(config.period);
  GroupModel group;
  group.spec = spec;
  const double life = std::max(period, to_seconds(config.command_life));
  group.command_life = life;
  group.braking = {limits.braking, period, std::max(static_cast<double>(limits.watchdog), life - period)};
  const bool at_once = limits.follows == Follows::kAtOnce;
  group.model = {at_once ? std::numeric_limits<double>::infinity() : static_cast<double>(limits.acceleration),
                 limits.response_time};
  group.change_limit = limits.acceleration * period;
  group.most_nudge = limits.speed * period;
  const double extent = largest_coordinate(config.fence);
  const double pose = pose_rounding(extent);
  group.nudge_from = std::max(0.5 * static_cast<double>(limits.tube), 0.5 * pose);
  group.kept = static_cast<double>(limits.radius) + static_cast<double>(limits.tube) +
               arc_height(limits, period) + pose + braking_rounding(limits, period) +
               geometry_rounding(extent + group.usual_reach());
  // A tenth of the body, and what a tick's path may leave its chord by: the robot must be able to start
  // again.
  group.clearance = {group.kept, std::max(0.1 * static_cast<double>(limits.radius), 1e-3) +
                                     0.625 * period * group.change_limit};
  return group;
}

}  // namespace mayfly
