// What may be wrong with a robot, a link or ourselves, as the detectors tell it: one bit each, fresh every
// tick.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mayfly {

// In the order of the fault table (docs/explanation/safety.md); its reactions are data beside it.
enum class Symptom : std::uint8_t {
  // Of one robot.
  kSilent,         // nothing was heard of it for longer than the limit
  kLinkDegraded,   // too few of the polls in the window were answered
  kStalePose,      // its pose is older than the limit
  kFrozenPose,     // fresh stamps, the same bits, while it is told to move
  kPoseNotFinite,  // a NaN or an infinity that claimed to be valid
  kPoseJump,       // farther from where it was expected than it can have got
  kTrackingError,  // measured and reference differ by more than the tube: the guarantee is suspended
  kOutOfFence,
  kTooNear,  // its reservation is nearer to another's than the two may be
  kBatteryLow,
  kBatteryCritical,
  kBatteryUnknown,  // not a number, or a jump
  kCommandRefused,  // expired, out of sequence, or in a state that does not allow it
  kCommandNotFinite,
  kCommandAbsurd,    // a velocity far beyond what it can do
  kLimitBroken,      // the command that would have been sent is beyond speed or acceleration: ours to mend
  kInvariantBroken,  // another invariant of what is sent does not hold: ours as well
  // Of everybody.
  kIdSwap,  // two jumped at once, and exchanged they fit
  kLinkLost,
  kPlannerStalled,  // the newest plan is too old, or never came
  kTickLate,        // our tick ended after its deadline
  kTickGap,         // several periods passed at once: a suspended machine
  kSimulationFailed,
  kOperatorHold,
  kEmergencyStop,
  kCount
};
inline constexpr std::size_t kSymptoms = static_cast<std::size_t>(Symptom::kCount);

// A set of them; plain data.
class Symptoms {
 public:
  constexpr void add(Symptom symptom) noexcept { bits_ |= bit(symptom); }
  constexpr void add(Symptoms others) noexcept { bits_ |= others.bits_; }
  constexpr void remove(Symptoms others) noexcept { bits_ &= ~others.bits_; }
  constexpr bool has(Symptom symptom) const noexcept { return (bits_ & bit(symptom)) != 0; }
  constexpr bool empty() const noexcept { return bits_ == 0; }
  constexpr bool operator==(const Symptoms&) const = default;

 private:
  static constexpr std::uint32_t bit(Symptom symptom) { return 1U << static_cast<unsigned>(symptom); }

  std::uint32_t bits_ = 0;
};
static_assert(kSymptoms <= 32);

// What is done about it (safety.md §2): each includes those before it.
enum class Severity : std::uint8_t {
  kNone,
  kReport,   // R0
  kClamp,    // R1: the governor changes the command
  kHold,     // R2: that robot brakes inside its reservation, then holds
  kHoldAll,  // R3: so does everybody; from here on latched until an operator acknowledges
  kLand,     // R4: that robot lands or returns; on the ground it stops
  kCut,      // R5: motors off
  kCount
};
inline constexpr std::size_t kSeverities = static_cast<std::size_t>(Severity::kCount);

}  // namespace mayfly
