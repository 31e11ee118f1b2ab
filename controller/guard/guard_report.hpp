// What a guard has to tell of a run.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/governor/governor_config.hpp"
#include "controller/guard/invariants.hpp"
#include "controller/guard/wish_desk.hpp"
#include "controller/safety/reactions.hpp"

namespace mayfly {

// A reaction that began. Times are the run's clock's.
struct GuardEvent {
  Time at{0};
  RobotIndex robot = kEveryRobot;
  Symptom symptom = Symptom::kCount;
  Severity severity = Severity::kNone;
};

struct GuardReport {
  Severity worst = Severity::kNone;  // ever
  std::uint64_t ticks = 0;
  std::uint64_t missed_acts = 0;  // sense() without an act() after it
  std::uint64_t incidents = 0;    // black boxes that were sealed, or would have been
  InvariantCounters invariants;
  ReactionCounters reactions;
  WishCounters wishes;
  GovernorCounters governor;
  std::uint64_t events_not_kept = 0;
};

}  // namespace mayfly
