// The one table of the faults that a scenario can inject. The scenario's keys, the reference page
// (docs/reference/faults.md), `mayfly bench faults` and its matrix all come from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "controller/safety/symptoms.hpp"

namespace mayfly {

enum class FaultKind : std::uint8_t {
  kLinkLost,
  kRobotSilent,
  kLinkDegraded,
  kLinkLatency,
  kPoseStale,
  kPoseFrozen,
  kPoseNan,
  kPoseJump,
  kPoseGhost,
  kIdSwap,
  kWind,
  kWeakMotor,
  kStartTooNear,
  kStartOutside,
  kBatteryLow,
  kBatteryCritical,
  kBatteryJump,
  kBatteryNan,
  kPlannerStall,
  kPlannerAbsurd,
  kPlannerNan,
  kCommandReplay,
  kTickLate,
  kTickGap,
  kSimulationFailed,
  kOperatorHold,
  kEmergencyStop,
  kCount
};
inline constexpr std::size_t kFaultKinds = static_cast<std::size_t>(FaultKind::kCount);

// Where it is put in, as near to where it happens in life as a simulation comes.
enum class FaultPlace : std::uint8_t { kRobots, kStart, kPlanner, kClock, kOperator };

// Whom it strikes: the robots that are named, two of them, or everybody.
enum class FaultTarget : std::uint8_t { kRobots, kPair, kEverybody };

// What says how bad it is, and the scenario's key for that.
enum class FaultSize : std::uint8_t { kNone, kShare, kDistance, kSpeed, kTime };

struct FaultRow {
  FaultKind kind = FaultKind::kCount;
  std::string_view name;  // of the scenario: "robot_silent"
  FaultPlace place = FaultPlace::kRobots;
  FaultTarget target = FaultTarget::kRobots;
  FaultSize size = FaultSize::kNone;
  double usual_size = 0.0;                // share of 1, m, m/s or s
  Symptom symptom = Symptom::kCount;      // what has to be noticed
  Severity reaction = Severity::kReport;  // what has to be done about it, at least
  double bound_s = 0.0;                   // within which, beside `bound_ticks`
  int bound_ticks = 1;
  std::string_view text;  // one sentence
};

// In the order of FaultKind.
std::span<const FaultRow> fault_rows();
const FaultRow& fault_row(FaultKind kind);
// Null where there is none of that name.
const FaultRow* find_fault(std::string_view name);
std::vector<std::string> fault_names();

// The scenario's key of a size ("share"); empty for kNone.
std::string_view key_of(FaultSize size);
std::string_view unit_of(FaultSize size);

// "at once", "within 200 ms and 1 tick": the longest that a fault may go unanswered, from where its symptom
// can be seen first.
std::string bound_text(const FaultRow& row);

// The table of docs/reference/faults.md, in Markdown: what is there is held to this.
std::string fault_reference_table();

}  // namespace mayfly
