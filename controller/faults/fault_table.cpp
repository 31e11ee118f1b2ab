#include "controller/faults/fault_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "controller/safety/reaction_table.hpp"

namespace mayfly {
namespace {

constexpr std::array<FaultRow, kFaultKinds> kRows{{
    {FaultKind::kLinkLost, "link_lost", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kLinkLost, Severity::kHoldAll, 0.1, 1,
     "The link of the robots answers nothing and carries nothing, for all who are on it; they obey their "
     "last "
     "command until its deadline."},
    {FaultKind::kRobotSilent, "robot_silent", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone,
     0.0, Symptom::kSilent, Severity::kHold, 0.2, 1,
     "Nothing is heard of the robot, and no command reaches it; its pose is measured from outside, and goes "
     "on."},
    {FaultKind::kLinkDegraded, "link_degraded", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kShare,
     0.5, Symptom::kLinkDegraded, Severity::kReport, 1.0, 1,
     "This share of the polls and of the commands is lost."},
    {FaultKind::kLinkLatency, "link_latency", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kTime,
     0.04, Symptom::kLinkDegraded, Severity::kReport, 1.0, 1,
     "Commands and answers are so late; an answer that is later than the next poll counts as none."},
    {FaultKind::kPoseStale, "pose_stale", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kStalePose, Severity::kHold, 0.1, 2, "No pose of the robot comes."},
    {FaultKind::kPoseFrozen, "pose_frozen", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kFrozenPose, Severity::kHold, 0.1, 2,
     "The same pose comes again and again, with fresh stamps."},
    {FaultKind::kPoseNan, "pose_nan", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kPoseNotFinite, Severity::kReport, 0.0, 1, "The pose is not a number, and claims to be valid."},
    {FaultKind::kPoseJump, "pose_jump", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kDistance, 1.0,
     Symptom::kPoseJump, Severity::kReport, 0.0, 1, "The pose is told this far from where the robot is."},
    {FaultKind::kPoseGhost, "pose_ghost", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kDistance,
     1.0, Symptom::kPoseJump, Severity::kReport, 0.0, 1,
     "Something so far away is tracked under the robot's name as well: its pose and the robot's come in "
     "turn, "
     "every 30 ms."},
    {FaultKind::kIdSwap, "id_swap", FaultPlace::kRobots, FaultTarget::kPair, FaultSize::kNone, 0.0,
     Symptom::kIdSwap, Severity::kHoldAll, 0.0, 3, "Two robots are told in each other's place."},
    {FaultKind::kWind, "wind", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kSpeed, 0.5,
     Symptom::kTrackingError, Severity::kHold, 0.04, 1,
     "The robot drifts at this velocity, on top of what it is told."},
    {FaultKind::kWeakMotor, "weak_motor", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kShare, 0.3,
     Symptom::kTrackingError, Severity::kHold, 0.04, 1,
     "This share is left of the robot's speed and acceleration."},
    {FaultKind::kStartTooNear, "start_too_near", FaultPlace::kStart, FaultTarget::kPair, FaultSize::kDistance,
     0.15, Symptom::kTooNear, Severity::kClamp, 0.0, 1, "The second robot starts this far from the first."},
    {FaultKind::kStartOutside, "start_outside", FaultPlace::kStart, FaultTarget::kRobots,
     FaultSize::kDistance, 0.3, Symptom::kOutOfFence, Severity::kClamp, 0.0, 1,
     "The robot starts so far outside of `world.bounds`."},
    {FaultKind::kBatteryLow, "battery_low", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kShare,
     0.15, Symptom::kBatteryLow, Severity::kReport, 1.0, 1, "No more than this share of the charge is left."},
    {FaultKind::kBatteryCritical, "battery_critical", FaultPlace::kRobots, FaultTarget::kRobots,
     FaultSize::kShare, 0.05, Symptom::kBatteryCritical, Severity::kLand, 1.0, 1,
     "No more than this share of the charge is left."},
    {FaultKind::kBatteryJump, "battery_jump", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kShare,
     0.5, Symptom::kBatteryUnknown, Severity::kReport, 1.0, 1,
     "The charge is told lower by this share, at once."},
    {FaultKind::kBatteryNan, "battery_nan", FaultPlace::kRobots, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kBatteryUnknown, Severity::kReport, 1.0, 1, "The charge is told as not a number."},
    {FaultKind::kPlannerStall, "planner_stall", FaultPlace::kPlanner, FaultTarget::kEverybody,
     FaultSize::kNone, 0.0, Symptom::kPlannerStalled, Severity::kReport, 0.1, 2,
     "The planner's last wish stays what it was, with its old deadline and number."},
    {FaultKind::kPlannerAbsurd, "planner_absurd", FaultPlace::kPlanner, FaultTarget::kRobots,
     FaultSize::kSpeed, 1e6, Symptom::kCommandAbsurd, Severity::kClamp, 0.0, 1,
     "The planner wants this velocity, in a direction that is new at every tick."},
    {FaultKind::kPlannerNan, "planner_nan", FaultPlace::kPlanner, FaultTarget::kRobots, FaultSize::kNone, 0.0,
     Symptom::kCommandNotFinite, Severity::kReport, 0.0, 1,
     "The planner wants a velocity that is not a number."},
    {FaultKind::kCommandReplay, "command_replay", FaultPlace::kPlanner, FaultTarget::kEverybody,
     FaultSize::kTime, 0.5, Symptom::kCommandRefused, Severity::kReport, 0.0, 1,
     "A wish that is so old comes again, with a fresh deadline and its old number; of one tick's age it has "
     "been overtaken."},
    {FaultKind::kTickLate, "tick_late", FaultPlace::kClock, FaultTarget::kEverybody, FaultSize::kTime, 0.03,
     Symptom::kTickLate, Severity::kReport, 0.1, 1, "Planning takes this long, at every tick."},
    {FaultKind::kTickGap, "tick_gap", FaultPlace::kClock, FaultTarget::kEverybody, FaultSize::kTime, 0.5,
     Symptom::kTickGap, Severity::kHoldAll, 0.5, 1,
     "The machine sleeps for this long, once; afterwards time goes on."},
    {FaultKind::kSimulationFailed, "simulation_failed", FaultPlace::kRobots, FaultTarget::kEverybody,
     FaultSize::kNone, 0.0, Symptom::kSimulationFailed, Severity::kHoldAll, 0.1, 1,
     "What steps the simulated robots fails, for good: a device that is lost."},
    {FaultKind::kOperatorHold, "operator_hold", FaultPlace::kOperator, FaultTarget::kEverybody,
     FaultSize::kNone, 0.0, Symptom::kOperatorHold, Severity::kHold, 0.0, 1,
     "An operator asks the swarm to hold, as Ctrl-C does; the flight ends when it stands still."},
    {FaultKind::kEmergencyStop, "emergency_stop", FaultPlace::kOperator, FaultTarget::kEverybody,
     FaultSize::kNone, 0.0, Symptom::kEmergencyStop, Severity::kHoldAll, 0.0, 1,
     "An operator stops everything, as Ctrl-C twice does; the flight ends."},
}};

struct SizeName {
  std::string_view key, unit;
};
// In the order of FaultSize.
constexpr std::array<SizeName, 5> kSizes{
    {{"", ""}, {"share", ""}, {"distance", "m"}, {"speed", "m/s"}, {"time", "s"}}};

// In the order of FaultTarget.
constexpr std::array<std::string_view, 3> kTargets{"robots", "two robots", "everybody"};

constexpr bool in_order() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (kRows[i].kind != static_cast<FaultKind>(i)) {
      return false;
    }
  }
  return true;
}
static_assert(in_order());

}  // namespace

std::span<const FaultRow> fault_rows() {
  return kRows;
}

const FaultRow& fault_row(FaultKind kind) {
  return kRows[static_cast<std::size_t>(kind)];
}

const FaultRow* find_fault(std::string_view name) {
  const auto* const row =
      std::find_if(kRows.begin(), kRows.end(), [&](const FaultRow& r) { return r.name == name; });
  return row == kRows.end() ? nullptr : row;
}

std::vector<std::string> fault_names() {
  std::vector<std::string> names;
  names.reserve(kRows.size());
  for (const FaultRow& row : kRows) {
    names.emplace_back(row.name);
  }
  return names;
}

std::string_view key_of(FaultSize size) {
  return kSizes[static_cast<std::size_t>(size)].key;
}

std::string_view unit_of(FaultSize size) {
  return kSizes[static_cast<std::size_t>(size)].unit;
}

std::string bound_text(const FaultRow& row) {
  const std::string ticks = fmt::format("{} tick{}", row.bound_ticks, row.bound_ticks == 1 ? "" : "s");
  return row.bound_s > 0.0 ? fmt::format("{:g} ms + {}", 1e3 * row.bound_s, ticks) : ticks;
}

std::string fault_reference_table() {
  std::string page =
      "| fault | what happens | strikes | size | usual size | symptom | at least | within |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const FaultRow& row : fault_rows()) {
    const bool has_size = row.size != FaultSize::kNone;
    page += fmt::format(
        "| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", row.name, row.text,
        kTargets[static_cast<std::size_t>(row.target)], has_size ? fmt::format("`{}`", key_of(row.size)) : "",
        has_size
            ? fmt::format("{:g}{}{}", row.usual_size, unit_of(row.size).empty() ? "" : " ", unit_of(row.size))
            : "",
        row.symptom == Symptom::kCount ? "" : info_of(row.symptom).name, name_of(row.reaction),
        bound_text(row));
  }
  return page;
}

}  // namespace mayfly
