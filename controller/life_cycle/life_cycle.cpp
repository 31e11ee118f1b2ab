#include "controller/life_cycle/life_cycle.hpp"

#include <algorithm>

namespace mayfly {

LifeCycles::LifeCycles(const LifeCycleConfig& config)
    : config_(config), states_(config.robots, RobotState::kUnknown), airborne_(config.robots) {}

bool LifeCycles::request(RobotIndex robot, RobotEvent event) noexcept {
  const bool accepted = robot < states_.size() && apply(robot, event);
  if (accepted) {
    ++counters_.accepted;
  } else {
    ++counters_.refused;
    ++counters_.refused_by_event[static_cast<std::size_t>(event)];
  }
  return accepted;
}

bool LifeCycles::apply(RobotIndex robot, RobotEvent event) noexcept {
  const std::optional<RobotState> next = next_state(states_[robot], event);
  states_[robot] = next.value_or(states_[robot]);
  return next.has_value();
}

// In the order of a robot's life, so that one tick takes it as far as what is seen allows.
void LifeCycles::observe(RobotIndex robot, const Observation& seen) noexcept {
  const Time heard = std::max(seen.telemetry.heard, seen.sampled);
  const bool answers = heard >= seen.now - config_.lost_after;
  // A battery that nobody measures is a NaN, and is not below anything.
  const bool good = seen.known && seen.fit && !(seen.telemetry.battery < config_.least_battery);
  const bool airborne = seen.telemetry.airborne;
  airborne_[robot] = airborne ? 1 : 0;
  apply(robot, answers ? RobotEvent::kHeard : RobotEvent::kLost);
  apply(robot, good ? RobotEvent::kChecksPassed : RobotEvent::kChecksFailed);
  if (!airborne) {
    apply(robot, RobotEvent::kLanded);
    return;
  }
  // Nobody arms a robot that flies already.
  apply(robot, RobotEvent::kArm);
  apply(robot, RobotEvent::kAirborne);
}

CommandKind LifeCycles::admit(RobotIndex robot, CommandKind wish) noexcept {
  const bool allowed = allows(states_[robot], wish);
  if (wish != CommandKind::kNone && allowed) {
    apply_order(robot, wish);
    return wish;
  }
  counters_.refused_commands += allowed ? 0 : 1;
  return own_command(states_[robot], airborne_[robot] != 0);
}

void LifeCycles::apply_order(RobotIndex robot, CommandKind wish) noexcept {
  if (wish == CommandKind::kTakeOff) {
    apply(robot, RobotEvent::kTakeOff);
  } else if (wish == CommandKind::kLand) {
    apply(robot, RobotEvent::kLand);
  }
}

}  // namespace mayfly
