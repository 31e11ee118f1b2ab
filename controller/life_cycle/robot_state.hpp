// The life of a robot, from nothing to flight and back: which state may follow which, as a table.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mayfly {

enum class RobotState : std::uint8_t {
  kUnknown,    // never heard of
  kConnected,  // answers on its link
  kChecked,    // its pose, battery and limits are good
  kArmed,      // motors may turn
  kTakingOff,
  kFlying,  // the only one in which a planner's velocities reach it
  kHolding,
  kReturning,
  kLanding,
  kOff,    // on the ground, motors off, after a flight
  kFault,  // latched; an operator clears it
  kCount
};
inline constexpr std::size_t kRobotStates = static_cast<std::size_t>(RobotState::kCount);

enum class RobotEvent : std::uint8_t {
  kHeard,  // its link has an answer
  kChecksPassed,
  kChecksFailed,
  kArm,
  kDisarm,
  kTakeOff,
  kAirborne,  // take-off is done, or it was found in the air
  kHold,
  kResume,
  kReturn,
  kArrived,  // where it was to return to
  kLand,
  kLanded,
  kLost,  // its link has had no answer for too long
  kFail,
  kClear,  // an operator acknowledged
  kCount
};
inline constexpr std::size_t kRobotEvents = static_cast<std::size_t>(RobotEvent::kCount);

}  // namespace mayfly
