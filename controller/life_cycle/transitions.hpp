// The table of a robot's life as data, and what may be sent to it in which state. The reference page
// docs/reference/life-cycle.md is held to it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "controller/life_cycle/robot_state.hpp"
#include "core/hal.hpp"

namespace mayfly {

struct Transition {
  RobotState from;
  RobotEvent event;
  RobotState to;
};

namespace life_cycle {

using S = RobotState;
using E = RobotEvent;

// All that is allowed; everything else is refused. Whatever goes wrong in the air ends in kFault, which
// nobody leaves without an operator. Landing is not called off: who ordered it may have had no choice.
inline constexpr std::array kTransitions = {
    Transition{S::kUnknown, E::kHeard, S::kConnected},
    Transition{S::kUnknown, E::kFail, S::kFault},
    Transition{S::kConnected, E::kChecksPassed, S::kChecked},
    Transition{S::kConnected, E::kLost, S::kUnknown},
    Transition{S::kConnected, E::kFail, S::kFault},
    Transition{S::kChecked, E::kChecksFailed, S::kConnected},
    Transition{S::kChecked, E::kArm, S::kArmed},
    Transition{S::kChecked, E::kLost, S::kUnknown},
    Transition{S::kChecked, E::kFail, S::kFault},
    Transition{S::kArmed, E::kChecksFailed, S::kConnected},
    Transition{S::kArmed, E::kDisarm, S::kChecked},
    Transition{S::kArmed, E::kTakeOff, S::kTakingOff},
    Transition{S::kArmed, E::kAirborne, S::kFlying},
    Transition{S::kArmed, E::kLost, S::kFault},
    Transition{S::kArmed, E::kFail, S::kFault},
    Transition{S::kTakingOff, E::kAirborne, S::kFlying},
    Transition{S::kTakingOff, E::kHold, S::kHolding},
    Transition{S::kTakingOff, E::kLand, S::kLanding},
    Transition{S::kTakingOff, E::kLost, S::kFault},
    Transition{S::kTakingOff, E::kFail, S::kFault},
    Transition{S::kFlying, E::kHold, S::kHolding},
    Transition{S::kFlying, E::kReturn, S::kReturning},
    Transition{S::kFlying, E::kLand, S::kLanding},
    Transition{S::kFlying, E::kLanded, S::kOff},
    Transition{S::kFlying, E::kLost, S::kFault},
    Transition{S::kFlying, E::kFail, S::kFault},
    Transition{S::kHolding, E::kResume, S::kFlying},
    Transition{S::kHolding, E::kReturn, S::kReturning},
    Transition{S::kHolding, E::kLand, S::kLanding},
    Transition{S::kHolding, E::kLanded, S::kOff},
    Transition{S::kHolding, E::kLost, S::kFault},
    Transition{S::kHolding, E::kFail, S::kFault},
    Transition{S::kReturning, E::kHold, S::kHolding},
    Transition{S::kReturning, E::kResume, S::kFlying},
    Transition{S::kReturning, E::kArrived, S::kHolding},
    Transition{S::kReturning, E::kLand, S::kLanding},
    Transition{S::kReturning, E::kLanded, S::kOff},
    Transition{S::kReturning, E::kLost, S::kFault},
    Transition{S::kReturning, E::kFail, S::kFault},
    Transition{S::kLanding, E::kLanded, S::kOff},
    Transition{S::kLanding, E::kLost, S::kFault},
    Transition{S::kLanding, E::kFail, S::kFault},
    Transition{S::kOff, E::kClear, S::kUnknown},
    Transition{S::kOff, E::kFail, S::kFault},
    Transition{S::kFault, E::kClear, S::kUnknown},
};

// kCount where the event is refused.
using Table = std::array<std::array<RobotState, kRobotEvents>, kRobotStates>;

constexpr Table make_table() {
  Table table{};
  for (auto& row : table) {
    row.fill(RobotState::kCount);
  }
  for (const Transition& t : kTransitions) {
    table[static_cast<std::size_t>(t.from)][static_cast<std::size_t>(t.event)] = t.to;
  }
  return table;
}
inline constexpr Table kTable = make_table();

}  // namespace life_cycle

// Where an event leads; nothing where it is refused.
constexpr std::optional<RobotState> next_state(RobotState state, RobotEvent event) noexcept {
  const RobotState next =
      life_cycle::kTable[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
  return next == RobotState::kCount ? std::nullopt : std::optional(next);
}

// Whether a planner's wish of this kind may reach a robot in this state. No wish is allowed everywhere.
constexpr bool allows(RobotState state, CommandKind kind) noexcept;
// What is sent to a robot in this state of whom nothing is wished, or nothing that it may be sent.
constexpr CommandKind own_command(RobotState state, bool airborne) noexcept;

// Whether its motors may turn: what goes wrong with it then matters.
constexpr bool is_armed(RobotState state) noexcept {
  return (state >= RobotState::kArmed && state <= RobotState::kLanding) || state == RobotState::kFault;
}

// As on the reference page: "taking off", "checks passed".
std::string_view name_of(RobotState state) noexcept;
std::string_view name_of(RobotEvent event) noexcept;
std::string_view name_of(CommandKind kind) noexcept;

namespace life_cycle {

using C = CommandKind;

struct Orders {
  CommandKind on_ground;  // where nothing else may be sent
  CommandKind in_air;
  bool velocity, hold, take_off, land, stop;  // what a planner may wish
};

// One row a state, in the order of RobotState. Neither a take-off, nor a way back, nor a landing is held up
// by a planner that has nothing better to say; the velocity back is the guard's own. After a flight motors
// stay off.
inline constexpr std::array<Orders, kRobotStates> kOrders = {{
    {C::kNone, C::kHold, false, true, false, false, true},       // kUnknown
    {C::kNone, C::kHold, false, true, false, false, true},       // kConnected
    {C::kNone, C::kHold, false, true, false, false, true},       // kChecked
    {C::kNone, C::kHold, false, true, true, false, true},        // kArmed
    {C::kTakeOff, C::kTakeOff, false, false, true, true, true},  // kTakingOff
    {C::kHold, C::kHold, true, true, false, true, true},         // kFlying
    {C::kHold, C::kHold, false, true, false, true, true},        // kHolding
    {C::kHold, C::kVelocity, false, false, false, true, true},   // kReturning
    {C::kLand, C::kLand, false, false, false, true, true},       // kLanding
    {C::kStop, C::kStop, false, false, false, false, true},      // kOff
    {C::kStop, C::kHold, false, true, false, true, true},        // kFault
}};

}  // namespace life_cycle

constexpr bool allows(RobotState state, CommandKind kind) noexcept {
  const life_cycle::Orders& orders = life_cycle::kOrders[static_cast<std::size_t>(state)];
  const std::array<bool, 6> allowed = {true,        orders.velocity, orders.hold, orders.take_off,
                                       orders.land, orders.stop};
  return allowed[static_cast<std::size_t>(kind)];
}

constexpr CommandKind own_command(RobotState state, bool airborne) noexcept {
  const life_cycle::Orders& orders = life_cycle::kOrders[static_cast<std::size_t>(state)];
  return airborne ? orders.in_air : orders.on_ground;
}

}  // namespace mayfly
