#include "controller/flight/flight_config.hpp"

#include <algorithm>
#include <cmath>

#include "controller/flight/motion_questions.hpp"
#include "controller/flight/swarm_cost.hpp"
#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

// A state older than this many control periods, or than this time, whichever is longer, counts as stale.
constexpr int kStatePeriods = 5;
constexpr double kStateSeconds = 0.1;

// What is sent is good for this many control periods: long enough for a tick that is skipped and its jitter,
// and no longer, because room is kept for all that a robot does until then.
constexpr double kCommandPeriods = 2.5;

ObstacleView obstacle_view(const World& world, const Motion& motion) {
  ObstacleView view;
  if (!world.solid.empty()) {
    view.sampled = {world.distance.distance.data(), world.grid, world.nested.get()};
    view.exact = [&solid = world.solid](glm::vec3 p) { return solid.signed_distance(p); };
  }
  view.moving = moving_obstacles(world.moving, motion);
  return view;
}

}  // namespace

Time most_state_age(const Scenario& scenario) {
  const Time period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  return std::max(kStatePeriods * period, from_seconds(kStateSeconds));
}

GovernorConfig governor_config(const Scenario& scenario, const World& world, const Motion& motion) {
  GovernorConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  config.command_life = from_seconds(kCommandPeriods * to_seconds(config.period));
  config.fence = scenario.world.bounds;
  for (const PlaneSpec& plane : scenario.world.fence) {
    config.half_spaces.push_back({plane.normal, plane.offset});
  }
  config.obstacles = obstacle_view(world, motion);
  std::size_t first = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    GovernorGroup group;
    group.first = first;
    group.count = static_cast<std::size_t>(swarm.count);
    group.enabled = swarm.governor;
    group.limits.speed = swarm.limits.speed;
    group.limits.acceleration = swarm.limits.acceleration;
    group.limits.braking = swarm.limits.braking;
    group.limits.tube = swarm.limits.tube;
    group.limits.watchdog = swarm.limits.watchdog;
    group.limits.downwash = swarm.limits.downwash;
    group.limits.latency = static_cast<int>(std::ceil(swarm.limits.latency * scenario.control.rate - 1e-3F));
    group.separation = swarm.limits.separation;
    group.limits.radius = swarm.radius;
    // With the HAL's delay, though the estimator predicts over it: what is kept reaches farther back then,
    // and so holds a robot whose poses are later than they should be.
    group.limits.response_time = response_time(scenario, swarm);
    group.limits.follows = follows(scenario, swarm);
    config.groups.push_back(group);
    first += group.count;
  }
  return config;
}

MetricsConfig metrics_config(const Scenario& scenario, const World& world, const Motion& motion) {
  MetricsConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  std::size_t first = 0;
  std::vector<std::size_t> goal_of;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    config.radii.insert(config.radii.end(), count, swarm.radius);
    config.swarms.push_back({first, count, !swarm.goal.empty()});
    goal_of.push_back(goal_index(scenario, swarm));
    first += count;
  }
  config.in_goal = [&goals = world.goals, &motion, goal_of](std::size_t swarm, glm::vec3 p) {
    const std::size_t goal = goal_of[swarm];
    return goals[goal].contains(p - motion.goal(goal));
  };
  config.obstacles = obstacle_view(world, motion);
  config.ticks = static_cast<std::uint64_t>(scenario.duration * static_cast<double>(scenario.control.rate));
  config.motions = motion_questions(scenario, world, motion);
  for (const Expectation& expectation : scenario.expect) {
    config.wall_clearance =
        config.wall_clearance || expectation.quantity == Expectation::Quantity::kWallClearance;
  }
  return config;
}

}  // namespace mayfly
