// All that a guard needs to know: plain numbers, no scenario, no file, no device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "controller/estimator/estimator_config.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/guard/black_box.hpp"
#include "controller/guard/exchange.hpp"
#include "controller/guard/monitor.hpp"
#include "controller/guard/telemetry_watch.hpp"
#include "controller/life_cycle/life_cycle.hpp"
#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

struct GuardConfig {
  Time period{0};           // of the tick
  GovernorConfig governor;  // its groups cover the robots; those with `enabled` false are not watched
  EstimatorConfig estimator;
  LifeCycleConfig life_cycle;
  TelemetryLimits telemetry;
  Time most_plan_age{0};  // a wish that was taken longer ago is none, whatever its deadline says
  Time command_life{0};   // after the last write robots go on for so long, then hold by themselves
  // m/s, at which a robot that must land (R4) is brought down through the governor, as far as the fence
  // reaches, before it is told to land; 0: it is told at once where it has come to rest.
  float descent = 0.5F;
  float homing = 0.5F;  // m/s, at which a robot that returns goes back
  // Takes robots out of the run and puts them back; null where nobody does. Outlives the guard.
  Exchange* exchange = nullptr;
  // The run's clock, asked when a tick ends; null: time is not watched. Else a tick that took longer than
  // `tick_budget` and a gap of several periods are seen (I12, kTickLate, kTickGap).
  const Clock* clock = nullptr;
  Time tick_budget{0};
  MonitorHooks hooks;
  // For tests of what the monitor finds, empty in every program: changes what the governor has left, or what
  // is told of a tick, before it is looked at.
  std::function<void(const GovernedColumns&, TickOutcome&)> tamper;
  BlackBoxConfig black_box;
};

// Refuses periods, ages and lives that are not positive, and parts that differ on how many robots there are.
Result<void> check(const GuardConfig& config);

}  // namespace mayfly
