#include "controller/flight/field_margin.hpp"

#include <algorithm>
#include <glm/vec3.hpp>
#include <numbers>

#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

// Of a cell: by as much the sampled distance may be off beside an edge, or in a body that is thinner than
// a cell. Whoever stands still is not pressed against what stands still; what moves presses everybody.
constexpr float kSharpness = 0.5F;

}  // namespace

double field_period(const Scenario& scenario) {
  return 1.0 / static_cast<double>(std::min(scenario.field_rate, scenario.decision_rate()));
}

double set_duration(const Scenario& scenario) {
  return field_period(scenario) + 1.0 / static_cast<double>(scenario.decision_rate());
}

float obstacle_margin(const Scenario& scenario, const PathSpec& path, double from_s, double until_s) {
  // Once at rest it stays so: what moves at all in that time moves at its beginning.
  if (path.velocity(from_s) == glm::vec3(0.0F)) {
    return 0.0F;
  }
  float lag = 0.0F;   // s
  float turn = 0.0F;  // s²/m
  for (const SwarmSpec& swarm : scenario.swarms) {
    lag = std::max(lag, response_time(scenario, swarm) + realtime_latency(scenario, swarm));
    turn = std::max(turn, 0.5F / swarm.limits.acceleration);
  }
  const auto on_the_way = static_cast<float>(0.5 * (until_s - from_s));
  const auto half_period = static_cast<float>(0.5 * field_period(scenario));
  return kSharpness * scenario.world.cell +
         path.speed * (on_the_way + half_period + 1.0F / approach_rate(scenario) + lag + turn * path.speed);
}

std::vector<float> wall_lengths(const Scenario& scenario, const Grid& grid) {
  std::vector<float> lengths{grid.cell};
  for (const SwarmSpec& swarm : scenario.swarms) {
    lengths.push_back(wall_reach(scenario, swarm, grid.cell));
    lengths.push_back(swarm.radius);
    lengths.push_back(swarm.cost.influence.value_or(2.0F * std::numbers::sqrt2_v<float> * grid.cell));
  }
  return lengths;
}

}  // namespace mayfly
