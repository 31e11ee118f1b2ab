// What holds of every tick, or is counted, recorded and answered (docs/explanation/guard.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "controller/safety/symptoms.hpp"

namespace mayfly {

enum class Invariant : std::uint8_t {
  kFinite,        // I1 numbers that are sent
  kSpeed,         // I2
  kAcceleration,  // I3
  kSeparation,    // I4 of the reservations
  kFence,         // I5 around the reservations
  kAges,          // I6 of the pose by which a robot moves, and of the command
  kTracking,      // I7 measured and reference
  kSequence,      // I8 strictly increasing, one command a robot and tick
  kArmed,         // I9 nobody else moves
  kTransition,    // I10 is in the table
  kSeverity,      // I11 falls only where it is acknowledged
  kTickBudget,    // I12
  kNoAllocation,  // I13 since the first tick
  kDecodes,       // I14 what was sent is what was governed
  kUnits,         // I15
  kOneOwner,      // I16 of the commands
  kHeartbeat,     // I17 only if all others held
  kCount
};
inline constexpr std::size_t kInvariants = static_cast<std::size_t>(Invariant::kCount);

// "I4 separation"
std::string_view name_of(Invariant invariant) noexcept;
// As in the summary: "separation".
std::string_view key_of(Invariant invariant) noexcept;
// What its breach looks like to the table of reactions.
Symptom symptom_of(Invariant invariant) noexcept;

// Breaches: robot-ticks, or ticks where no robot is at fault.
struct InvariantCounters {
  std::array<std::uint64_t, kInvariants> breaches{};
  std::uint64_t ticks = 0;  // that were looked at
  std::uint64_t ticks_that_held = 0;

  std::uint64_t of(Invariant invariant) const { return breaches[static_cast<std::size_t>(invariant)]; }
};

}  // namespace mayfly
