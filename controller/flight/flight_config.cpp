#include "controller/flight/flight_config.hpp"

#include <algorithm>

#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

// A state older than this many control periods, or than this time, whichever is longer, counts as stale.
constexpr int kStatePeriods = 5;
constexpr double kStateSeconds = 0.1;

ObstacleView obstacle_view(const World& world) {
  if (world.solid.empty()) {
    return {};
  }
  return {{world.distance.distance.data(), world.grid},
          [&solid = world.solid](glm::vec3 p) { return solid.signed_distance(p); }};
}

}  // namespace

GovernorConfig governor_config(const Scenario& scenario, const World& world) {
  GovernorConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  config.max_state_age = std::max(kStatePeriods * config.period, from_seconds(kStateSeconds));
  config.fence = scenario.world.bounds;
  config.obstacles = obstacle_view(world);
  std::size_t first = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    GovernorGroup group;
    group.first = first;
    group.count = static_cast<std::size_t>(swarm.count);
    group.enabled = swarm.governor;
    group.limits.speed = swarm.limits.speed;
    group.limits.acceleration = swarm.limits.acceleration;
    group.limits.braking = swarm.limits.acceleration;
    group.limits.radius = swarm.radius;
    group.limits.response_time = response_time(scenario, swarm);
    config.groups.push_back(group);
    first += group.count;
  }
  return config;
}

MetricsConfig metrics_config(const Scenario& scenario, const World& world) {
  MetricsConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  std::size_t first = 0;
  std::vector<std::size_t> goal_of;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    config.radii.insert(config.radii.end(), count, swarm.radius);
    config.swarms.push_back({first, count});
    const auto goal = std::find_if(scenario.world.goals.begin(), scenario.world.goals.end(),
                                   [&](const GoalSpec& g) { return g.name == swarm.goal; });
    goal_of.push_back(static_cast<std::size_t>(goal - scenario.world.goals.begin()));
    first += count;
  }
  config.in_goal = [&goals = world.goals, goal_of](std::size_t swarm, glm::vec3 p) {
    return goals[goal_of[swarm]].contains(p);
  };
  config.obstacles = obstacle_view(world);
  return config;
}

}  // namespace mayfly
