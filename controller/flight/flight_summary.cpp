// What a flight came to: the last thing that is asked of a FlightLoop.
#include <algorithm>
#include <utility>

#include "controller/flight/expectations.hpp"
#include "controller/flight/flight_guard.hpp"
#include "controller/flight/flight_loop.hpp"
#include "controller/flight/noticed.hpp"

namespace mayfly {
namespace {

bool has_mde(const Scenario& scenario) {
  return std::any_of(scenario.swarms.begin(), scenario.swarms.end(), [](const SwarmSpec& swarm) {
    return swarm.mde_sweeps > 0 && swarm.limits.separation > 0;
  });
}

// What metrics_config() had measured for each expectation; `infeasible` is a share.
std::vector<std::optional<double>> asked_for(const Scenario& scenario, const MetricsResult& measured,
                                             std::optional<double> infeasible,
                                             const std::vector<FaultEvent>& faults) {
  std::vector<std::optional<double>> asked = measured.motions;
  for (std::size_t i = 0; i < scenario.expect.size(); ++i) {
    if (scenario.expect[i].quantity == Expectation::Quantity::kWallClearance) {
      asked[i] = measured.wall_clearance_m;
    } else if (scenario.expect[i].quantity == Expectation::Quantity::kInfeasible) {
      asked[i] = infeasible;
    } else if (scenario.expect[i].quantity == Expectation::Quantity::kNoticed) {
      asked[i] = noticed_after(scenario, scenario.expect[i].fault, faults);
    } else if (scenario.expect[i].quantity == Expectation::Quantity::kReacted) {
      asked[i] = reacted_after(scenario, scenario.expect[i].fault, scenario.expect[i].severity, faults);
    }
  }
  return asked;
}

}  // namespace

Summary FlightLoop::summarise(ControlSummary timing, double wall_s) const {
  const Scenario& scenario = parts_.scenario;
  Summary s;
  s.scenario = scenario.name;
  s.engine = parts_.engine.name();
  s.hal = parts_.hal.name();
  s.seed = scenario.seed;
  s.agents = agents_;
  s.ticks = ticks_;
  s.simulated_s = to_seconds(flown_);
  s.wall_s = wall_s;
  s.realtime_factor = wall_s > 0 ? s.simulated_s / wall_s : 0;
  const double agent_ticks = static_cast<double>(agents_) * static_cast<double>(ticks_);
  if (agent_ticks > 0) {
    s.ns_per_agent_tick = std::chrono::duration<double, std::nano>(work_).count() / agent_ticks;
  }
  const FieldPlanner::Totals& planned = planner_.totals();
  const double agent_plans = static_cast<double>(agents_) * static_cast<double>(planned.plans);
  if (agent_plans > 0 && has_mde(scenario)) {
    s.mde_percent = 100.0 * static_cast<double>(planned.moved) / agent_plans;
  }
  std::optional<double> infeasible;
  if (planner_.avoids()) {
    s.infeasible_agents = planned.infeasible;
    s.all_infeasible_s = all_infeasible_s_;
    infeasible = planned.avoiding > 0
                     ? static_cast<double>(planned.infeasible) / static_cast<double>(planned.avoiding)
                     : 0.0;
  }
  const MetricsResult measured = metrics_.result();
  s.reached_fraction = measured.reached_fraction;
  s.min_separation_m = measured.min_separation_m;
  s.collisions = measured.collisions;
  s.penetrations = measured.penetrations;
  s.max_speed_mps = measured.max_speed_mps;
  s.max_acceleration_mps2 = measured.max_acceleration_mps2;
  s.governor_interventions = guard_.report().governor.interventions;
  s.faults = with_reactions(faults_.told(guard_.robots()), guard_, began_);
  s.safety = told_of(guard_);
  s.safety.breaches = parts_.truth == nullptr ? std::nullopt : parts_.truth->breaches();
  s.control = std::move(timing);
  s.preprocessing_s = parts_.world.preprocessing;
  if (const FieldPlanner& planner = planner_; planner.keeper() != nullptr) {
    s.fields = planner.keeper()->summary();
  }
  s.stopped_by_user = stop_level() > 0;
  const auto reached = [&](const std::string& name) -> std::optional<double> {
    if (name.empty()) {
      return measured.reached_fraction;
    }
    const auto swarm = std::find_if(scenario.swarms.begin(), scenario.swarms.end(),
                                    [&](const SwarmSpec& spec) { return spec.name == name; });
    return measured.reached_fraction_of[static_cast<std::size_t>(swarm - scenario.swarms.begin())];
  };
  s.expect =
      hold_expectations(scenario.expect, s, reached, asked_for(scenario, measured, infeasible, s.faults));
  return s;
}

}  // namespace mayfly
