// What is done about a symptom, and after how long: the fault table's reactions as data.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "controller/safety/symptoms.hpp"
#include "core/clock.hpp"

namespace mayfly {

// Who answers a symptom of one robot. A symptom of everybody is everybody's.
enum class Scope : std::uint8_t { kRobot, kLink, kEverybody };

// Several rows of one symptom are its escalation; all that are due count, and the worst wins.
struct ReactionRow {
  Symptom symptom = Symptom::kCount;
  Time after{0};  // accrued time of the symptom; 0: the tick that shows it first
  int times = 1;  // and this many ticks that showed it
  Severity severity = Severity::kNone;
  Scope scope = Scope::kRobot;
};

struct SymptomInfo {
  std::string_view name;   // as in summaries and scenarios: "stale_pose"
  std::string_view cause;  // what an event says
  Time clears{0};          // health of this length ends a reaction below kHoldAll
  Time forgets{0};         // and of this length what was accrued: at least the longest delay of its rows
};

std::span<const ReactionRow> reaction_table() noexcept;
const SymptomInfo& info_of(Symptom symptom) noexcept;

// "R3 hold all"; for kNone "none".
std::string_view name_of(Severity severity) noexcept;
// As in the summary: "hold_all".
std::string_view key_of(Severity severity) noexcept;
std::string_view name_of(Scope scope) noexcept;

// docs/reference/fault-table.md, whole.
std::string fault_table_page();

}  // namespace mayfly
