// The robots' lives in a run: what is seen of each, what is asked of it, and which commands may reach it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/life_cycle/transitions.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

struct LifeCycleConfig {
  std::size_t robots = 0;
  Time lost_after{std::chrono::seconds(1)};  // nothing heard for longer: kLost
  float least_battery = 0.2F;                // share of the charge; a robot with less fails its checks
};

// What is seen of a robot at a tick.
struct Observation {
  Time now{0};
  // A HAL without telemetry leaves it at its defaults: `heard` then counts from the newest sample, the
  // battery is not checked, and the robot is taken to be in the air.
  Telemetry telemetry;
  Time sampled{Time::min()};  // stamp of its newest sample, Time::min() for none
  bool known = false;         // the estimate may be relied on
  bool fit = true;            // nothing else speaks against it: limits, firmware, symptoms
};

struct LifeCycleCounters {
  std::uint64_t accepted = 0, refused = 0;  // events that were asked for
  std::array<std::uint64_t, kRobotEvents> refused_by_event{};
  std::uint64_t refused_commands = 0;  // of a kind that the robot's state does not allow
};

// Each robot lives on its own: none waits for another. Nothing but the constructor allocates. One thread.
class LifeCycles {
 public:
  explicit LifeCycles(const LifeCycleConfig& config);

  // An operator's event, or one that somebody else has seen. False: refused, as the table says, and counted;
  // or there is no such robot.
  bool request(RobotIndex robot, RobotEvent event) noexcept;
  // What can be seen drives it on its own: heard, checks, airborne, landed, lost. A robot that is found in
  // the air when its checks are good goes to kFlying at once.
  void observe(RobotIndex robot, const Observation& seen) noexcept;
  // What may be sent of what a planner wishes: the wish, or what the robot's state says in its place, which
  // is counted. kNone is no wish, and is not counted.
  CommandKind admit(RobotIndex robot, CommandKind wish) noexcept;

  RobotState state(RobotIndex robot) const noexcept { return states_[robot]; }
  std::span<const RobotState> states() const noexcept { return states_; }
  const LifeCycleCounters& counters() const noexcept { return counters_; }

 private:
  bool apply(RobotIndex robot, RobotEvent event) noexcept;
  void apply_order(RobotIndex robot, CommandKind wish) noexcept;

  LifeCycleConfig config_;
  std::vector<RobotState> states_;
  std::vector<std::uint8_t> airborne_;  // as last seen
  LifeCycleCounters counters_;
};

}  // namespace mayfly
