#include "controller/safety/reaction_table.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace mayfly {
namespace {

using namespace std::chrono_literals;

constexpr ReactionRow kTable[] = {
    // Its limit (200 ms) is the detector's: landing begins a second after it was heard last.
    {Symptom::kSilent, 0ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kSilent, 800ms, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kLinkDegraded, 0ms, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kLinkDegraded, 1s, 1, Severity::kClamp, Scope::kRobot},
    {Symptom::kLinkDegraded, 10s, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kStalePose, 0ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kStalePose, 500ms, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kStalePose, 2s, 1, Severity::kCut, Scope::kRobot},
    {Symptom::kFrozenPose, 0ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kFrozenPose, 500ms, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kFrozenPose, 2s, 1, Severity::kCut, Scope::kRobot},
    // Such a sample is dropped: what comes of it is a stale pose.
    {Symptom::kPoseNotFinite, 0ms, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kPoseJump, 0ms, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kPoseJump, 0ms, 3, Severity::kHold, Scope::kRobot},
    {Symptom::kTrackingError, 0ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kTrackingError, 500ms, 1, Severity::kLand, Scope::kRobot},
    // The governor lets it come back, and go nowhere else.
    {Symptom::kOutOfFence, 0ms, 1, Severity::kClamp, Scope::kRobot},
    {Symptom::kOutOfFence, 2s, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kTooNear, 0ms, 1, Severity::kClamp, Scope::kRobot},
    {Symptom::kBatteryLow, 1s, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kBatteryCritical, 1s, 1, Severity::kLand, Scope::kRobot},
    {Symptom::kBatteryUnknown, 0ms, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kCommandRefused, 0ms, 1, Severity::kReport, Scope::kRobot},
    {Symptom::kCommandNotFinite, 0ms, 1, Severity::kClamp, Scope::kRobot},
    {Symptom::kCommandNotFinite, 500ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kCommandAbsurd, 0ms, 1, Severity::kClamp, Scope::kRobot},
    {Symptom::kLimitBroken, 0ms, 1, Severity::kHold, Scope::kRobot},
    {Symptom::kLimitBroken, 0ms, 3, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kInvariantBroken, 0ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kIdSwap, 0ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kLinkLost, 0ms, 1, Severity::kHold, Scope::kLink},
    {Symptom::kLinkLost, 100ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kPlannerStalled, 0ms, 1, Severity::kHold, Scope::kEverybody},
    {Symptom::kPlannerStalled, 1s, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kTickLate, 0ms, 1, Severity::kReport, Scope::kEverybody},
    {Symptom::kTickLate, 0ms, 3, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kTickGap, 0ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kSimulationFailed, 0ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kOperatorHold, 0ms, 1, Severity::kHoldAll, Scope::kEverybody},
    {Symptom::kEmergencyStop, 0ms, 1, Severity::kCut, Scope::kEverybody},
};

// In the order of Symptom.
constexpr std::array<SymptomInfo, kSymptoms> kInfos = {{
    {"silent", "it does not answer", 100ms, 1s},
    {"link_degraded", "too many of its polls go unanswered", 500ms, 10s},
    {"stale_pose", "its pose is older than the limit", 0ms, 2s},
    {"frozen_pose", "its pose is the same, bit for bit, while it is told to move", 100ms, 2s},
    {"pose_not_finite", "its state is not a number", 0ms, 1s},
    {"pose_jump", "its pose is farther off than it can have moved", 0ms, 1s},
    {"tracking_error", "it is farther from its reference than the tube", 100ms, 1s},
    {"out_of_fence", "it is outside the fence", 0ms, 2s},
    {"too_near", "it is nearer to another than the two may be", 0ms, 1s},
    {"battery_low", "its battery is low", 5s, 5s},
    {"battery_critical", "its battery is nearly empty", 5s, 5s},
    {"battery_unknown", "the charge of its battery is not a number, or jumps", 1s, 1s},
    {"command_refused", "a command was refused: expired, out of sequence, or not allowed in its state", 0ms,
     1s},
    {"command_not_finite", "the velocity wished of it is not a number", 0ms, 1s},
    {"command_absurd", "the velocity wished of it is far beyond what it can do", 0ms, 1s},
    {"limit_broken", "what would have been sent was beyond its speed or acceleration", 100ms, 1s},
    {"invariant_broken", "an invariant of what is sent does not hold", 100ms, 1s},
    {"id_swap", "two robots have taken each other's places", 0ms, 1s},
    {"link_lost", "its link does not answer", 100ms, 1s},
    {"planner_stalled", "no plan that is young enough", 0ms, 1s},
    {"tick_late", "a tick ended after its deadline", 0ms, 1s},
    {"tick_gap", "several ticks' time passed at once", 0ms, 1s},
    {"simulation_failed", "the simulation of the robots has failed", 0ms, 1s},
    {"operator_hold", "the operator asked everybody to hold", 0ms, 1s},
    {"emergency_stop", "the operator asked for the emergency stop", 0ms, 1s},
}};

constexpr bool is_of_everybody(Symptom symptom) {
  return symptom >= Symptom::kIdSwap && symptom != Symptom::kLinkLost;
}

// Rows stand by symptom and grow worse; each symptom has one; what holds everybody is everybody's.
constexpr bool is_well_made() {
  auto symptom = static_cast<unsigned>(kTable[0].symptom);
  Severity worst = Severity::kNone;
  if (symptom != 0) {
    return false;
  }
  for (const ReactionRow& row : kTable) {
    const auto next = static_cast<unsigned>(row.symptom);
    worst = next == symptom ? worst : Severity::kNone;
    const bool in_order = next == symptom || next == symptom + 1;
    const bool holds_all = row.severity != Severity::kHoldAll || row.scope == Scope::kEverybody;
    const bool scoped = !is_of_everybody(row.symptom) || row.scope == Scope::kEverybody;
    if (!in_order || row.severity <= worst || !holds_all || !scoped || row.times < 1 ||
        row.after > kInfos[next].forgets || kInfos[next].clears > kInfos[next].forgets) {
      return false;
    }
    symptom = next;
    worst = row.severity;
  }
  return symptom + 1 == kSymptoms;
}
static_assert(is_well_made());

std::string in_ms(Time time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count()) + " ms";
}

std::string when(const ReactionRow& row) {
  std::string text = row.after > Time{0} ? "after " + in_ms(row.after) : "at once";
  if (row.times > 1) {
    text = "seen " + std::to_string(row.times) + " times";
  }
  return text;
}

}  // namespace

std::span<const ReactionRow> reaction_table() noexcept {
  return kTable;
}

const SymptomInfo& info_of(Symptom symptom) noexcept {
  return kInfos[std::min(static_cast<std::size_t>(symptom), kSymptoms - 1)];
}

std::string_view name_of(Severity severity) noexcept {
  constexpr std::string_view kNames[] = {"none",        "R0 report", "R1 clamp", "R2 hold",
                                         "R3 hold all", "R4 land",   "R5 cut"};
  return kNames[static_cast<std::size_t>(severity)];
}

std::string_view key_of(Severity severity) noexcept {
  constexpr std::string_view kKeys[] = {"none", "report", "clamp", "hold", "hold_all", "land", "cut"};
  return kKeys[static_cast<std::size_t>(severity)];
}

std::string_view name_of(Scope scope) noexcept {
  constexpr std::string_view kNames[] = {"that robot", "its link", "everybody"};
  return kNames[static_cast<std::size_t>(scope)];
}

std::string fault_table_page() {
  std::string page =
      "# Fault table\n"
      "\n"
      "What the guard does about each symptom. This page is written by the program from the table that "
      "flies\n"
      "(`controller/safety/reaction_table.cpp`); a test holds the two together. Delays begin at the tick "
      "that\n"
      "detects the symptom; how reactions combine, latch and clear is told in\n"
      "[the guard](../explanation/guard.md).\n"
      "\n"
      "| symptom | when | reaction | of | clears after | forgotten after |\n"
      "|---|---|---|---|---|---|\n";
  for (const ReactionRow& row : reaction_table()) {
    const SymptomInfo& info = info_of(row.symptom);
    page += "| `" + std::string(info.name) + "` | " + when(row) + " | " + std::string(name_of(row.severity)) +
            " | " + std::string(name_of(row.scope)) + " | " +
            (row.severity >= Severity::kHoldAll ? "acknowledged" : in_ms(info.clears)) + " | " +
            in_ms(info.forgets) + " |\n";
  }
  page +=
      "\n"
      "*Clears after*: so long in health, and the reaction ends; from R3 up it stays until an operator\n"
      "acknowledges it, which counts only where the symptom is gone. *Forgotten after*: so long in health, "
      "and\n"
      "the time that the symptom had accrued is forgotten. *Seen n times*: in ticks, with less than that "
      "time\n"
      "between two of them.\n"
      "\n"
      "| symptom | what it says |\n"
      "|---|---|\n";
  for (const SymptomInfo& info : kInfos) {
    page += "| `" + std::string(info.name) + "` | " + std::string(info.cause) + " |\n";
  }
  return page;
}

}  // namespace mayfly
