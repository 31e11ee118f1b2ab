#include "controller/flight/swarm_cost.hpp"

#include <algorithm>
#include <tuple>

namespace mayfly {
namespace {

bool is_painted_for(const BrushSpec& brush, const SwarmSpec& swarm) {
  return brush.term == BrushSpec::Term::kCost && (brush.swarm.empty() || brush.swarm == swarm.name);
}

}  // namespace

fields::CostParams cost_params(const SwarmSpec& swarm) {
  return {swarm.cost.length_weight, swarm.cost.repulsion_weight, swarm.cost.influence.value_or(0.0F),
          swarm.radius};
}

std::vector<fields::CostBrush> cost_brushes(const Scenario& scenario, const SwarmSpec& swarm) {
  std::vector<fields::CostBrush> brushes;
  for (const BrushSpec& brush : scenario.world.brushes) {
    if (is_painted_for(brush, swarm)) {
      const float sign = brush.effect == BrushSpec::Effect::kRepel ? 1.0F : -1.0F;
      brushes.push_back({brush.center, brush.radius, sign * brush.strength});
    }
  }
  return brushes;
}

bool share_cost(const Scenario& scenario, const SwarmSpec& a, const SwarmSpec& b) {
  const auto identity = [](const SwarmSpec& swarm) {
    const fields::CostParams params = cost_params(swarm);
    return std::tuple(swarm.goal, params.length_weight, params.repulsion_weight, params.influence,
                      params.clearance, swarm.cost.density_weight);
  };
  return a.is_guided() && b.is_guided() && identity(a) == identity(b) &&
         std::all_of(
             scenario.world.brushes.begin(), scenario.world.brushes.end(),
             [&](const BrushSpec& brush) { return is_painted_for(brush, a) == is_painted_for(brush, b); });
}

std::size_t goal_index(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto& goals = scenario.world.goals;
  const auto goal =
      std::find_if(goals.begin(), goals.end(), [&](const GoalSpec& g) { return g.name == swarm.goal; });
  return static_cast<std::size_t>(goal - goals.begin());
}

bool changes_in_flight(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto& obstacles = scenario.world.obstacles;
  const bool guide_changes = swarm.is_guided() && (swarm.cost.density_weight > 0.0F ||
                                                   scenario.world.goals[goal_index(scenario, swarm)].path);
  return guide_changes || std::any_of(obstacles.begin(), obstacles.end(),
                                      [](const ObstacleSpec& obstacle) { return obstacle.path.has_value(); });
}

}  // namespace mayfly
