// Between a planner and the robots: hears, estimates, judges, governs and writes, every tick, whatever the
// planner does.
//
//   robots ──HAL.read──► estimator ──► planner ──wish──► life cycle, governor, invariants ──HAL.write──►
//   robots
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "controller/estimator/estimator.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/life_cycle/robot_state.hpp"
#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

struct GuardConfig {
  Time period{0};  // of the tick
  GovernorConfig governor;
  EstimatorConfig estimator;
  Time most_plan_age{0};  // an older wish is none: everybody brakes
};

// One tick is sense(), then act(). Allocates at start only; blocks never; one thread.
class Guard {
 public:
  virtual ~Guard() = default;

  // Hears the robots and works out where they are.
  virtual HalResult sense(Time now) noexcept = 0;
  // `wish` is the newest that a planner handed over, however old: its deadline and sequence are judged here.
  // kNone for a robot means that nothing is wished of it.
  virtual HalResult act(Time now, const CommandColumns& wish) noexcept = 0;

  virtual EstimateColumns estimate() const noexcept = 0;
  virtual std::span<const RobotState> states() const noexcept = 0;
  virtual std::span<const Severity> severities() const noexcept = 0;

  // An operator's: clears what is latched where its cause is gone; returns what stays.
  virtual Severity acknowledge(Time now) noexcept = 0;
};

}  // namespace mayfly
