#include "controller/flight/flight_config.hpp"

#include <algorithm>

#include "controller/flight/swarm_cost.hpp"
#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

// A state older than this many control periods, or than this time, whichever is longer, counts as stale.
constexpr int kStatePeriods = 5;
constexpr double kStateSeconds = 0.1;

ObstacleView obstacle_view(const World& world, const Motion& motion) {
  ObstacleView view;
  if (!world.solid.empty()) {
    view.sampled = {world.distance.distance.data(), world.grid, world.nested.get()};
    view.exact = [&solid = world.solid](glm::vec3 p) { return solid.signed_distance(p); };
  }
  view.moving = moving_obstacles(world.moving, motion);
  return view;
}

// What an expectation asks of a swarm's motion; one of another kind where it asks nothing.
MotionQuestion motion_question(const Expectation& expectation, const Scenario& scenario, const World& world,
                               const Motion& motion) {
  using Quantity = Expectation::Quantity;
  using Kind = MotionQuestion::Kind;
  MotionQuestion question;
  std::size_t first = 0;
  std::size_t goal = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (swarm.name == expectation.swarm) {
      question.first = first;
      question.count = static_cast<std::size_t>(swarm.count);
      goal = goal_index(scenario, swarm);
    }
    first += static_cast<std::size_t>(swarm.count);
  }
  for (std::size_t g = 0; g < scenario.world.goals.size(); ++g) {
    goal = scenario.world.goals[g].name == expectation.goal ? g : goal;
  }
  if (expectation.quantity == Quantity::kCentreDrift) {
    question.kind = Kind::kCentreDrift;
  } else if (expectation.quantity == Quantity::kSpread) {
    question.kind = Kind::kSpread;
  } else if (expectation.quantity == Quantity::kTurns) {
    question.kind = Kind::kTurns;
    question.place = [axis = glm::dvec3(expectation.around.value_or(glm::vec3(0.0F)))] { return axis; };
  } else if (expectation.quantity == Quantity::kGoalDistance) {
    question.kind = Kind::kDistance;
    const Box box = world.goals[goal].bounds().value_or(Box{});
    const glm::dvec3 middle = 0.5 * (glm::dvec3(box.min) + glm::dvec3(box.max));
    question.place = [middle, &moved = motion.goal(goal)] { return middle + glm::dvec3(moved); };
  }
  return question;
}

}  // namespace

GovernorConfig governor_config(const Scenario& scenario, const World& world, const Motion& motion) {
  GovernorConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  config.max_state_age = std::max(kStatePeriods * config.period, from_seconds(kStateSeconds));
  config.fence = scenario.world.bounds;
  config.obstacles = obstacle_view(world, motion);
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

MetricsConfig metrics_config(const Scenario& scenario, const World& world, const Motion& motion) {
  MetricsConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  std::size_t first = 0;
  std::vector<std::size_t> goal_of;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    config.radii.insert(config.radii.end(), count, swarm.radius);
    config.swarms.push_back({first, count});
    goal_of.push_back(goal_index(scenario, swarm));
    first += count;
  }
  config.in_goal = [&goals = world.goals, &motion, goal_of](std::size_t swarm, glm::vec3 p) {
    const std::size_t goal = goal_of[swarm];
    return goals[goal].contains(p - motion.goal(goal));
  };
  config.obstacles = obstacle_view(world, motion);
  config.ticks = static_cast<std::uint64_t>(scenario.duration * static_cast<double>(scenario.control.rate));
  for (const Expectation& expectation : scenario.expect) {
    config.motions.push_back(motion_question(expectation, scenario, world, motion));
    config.wall_clearance =
        config.wall_clearance || expectation.quantity == Expectation::Quantity::kWallClearance;
  }
  return config;
}

}  // namespace mayfly
