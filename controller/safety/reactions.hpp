// From symptoms to severities, every tick: delays, escalation, latches.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/safety/reaction_table.hpp"
#include "core/hal.hpp"

namespace mayfly {

// A row of the table that became due, at the tick at which it did.
struct Reaction {
  RobotIndex robot = kEveryRobot;  // whose symptom; kEveryRobot for one of everybody
  Symptom symptom = Symptom::kCount;
  Severity severity = Severity::kNone;
  Scope scope = Scope::kRobot;
};

struct ReactionCounters {
  std::array<std::uint64_t, kSymptoms> by_symptom{};  // robot-ticks that showed it
  std::array<std::uint64_t, kSeverities> begun{};     // rows that became due
  std::uint64_t unlisted = 0;                         // of them, those that begun() had no room for
};

// A symptom's time accrues while it shows, and is forgotten only after the symptom's `forgets` without it:
// one that comes and goes escalates later than one that stays, but it does. A reaction below kHoldAll ends
// `clears` after its symptom; from kHoldAll up it is latched until acknowledge(). Of all that is due for a
// robot (its own, its link's, everybody's) the worst counts.
class Reactions {
 public:
  struct Robot {
    std::uint32_t link = 0;  // robots of one link have the same number, below the number of robots
    bool watched =
        true;  // false: its own symptoms count for nothing (`governor: off`); those of everybody do
  };

  explicit Reactions(std::span<const Robot> robots, std::span<const ReactionRow> table = reaction_table());

  // Symptoms as of `now`, one element a robot. Ticks come in order; the first one begins the count.
  void tick(Time now, std::span<const Symptoms> robots, Symptoms everybody) noexcept;

  // Clears latches whose symptoms are gone, with what these had accrued. Returns the worst that stays.
  Severity acknowledge() noexcept;

  std::span<const Severity> severities() const noexcept { return severities_; }  // one a robot
  Severity worst() const noexcept { return worst_; }                             // of all of them, now
  Severity everybodys() const noexcept;  // of what concerns everybody, latched or due
  // What the last tick began.
  std::span<const Reaction> begun() const noexcept { return begun_; }
  const ReactionCounters& counters() const noexcept { return counters_; }

 private:
  // Of one symptom of one robot, or of everybody.
  struct Track {
    Time accrued{0};
    Time healthy{0};  // since it showed last
    std::uint32_t times = 0;
    std::uint32_t due = 0;  // one bit a row of the symptom, in the table's order
  };
  // What is due, and what is latched.
  struct Level {
    Severity due = Severity::kNone;
    Severity latched = Severity::kNone;

    void add(Severity severity) noexcept;
    void begin_tick() noexcept { due = Severity::kNone; }
    void acknowledge() noexcept;
    Severity now() const noexcept { return due > latched ? due : latched; }
  };
  struct Slot {
    std::array<Track, kSymptoms> tracks{};
    Symptoms kept;  // those with anything accrued
  };

  void follow(RobotIndex robot, Slot& slot, Symptoms shown, Time passed) noexcept;
  bool still_counts(Track& track, Symptom symptom, bool shows, Time passed, bool was_kept) noexcept;
  void react(RobotIndex robot, Symptom symptom, Track& track) noexcept;
  void forget_healthy(Slot& slot) noexcept;
  void combine() noexcept;

  std::span<const ReactionRow> table_;
  std::array<std::span<const ReactionRow>, kSymptoms> rows_;
  std::vector<Robot> robots_;
  std::vector<std::uint32_t> slot_of_;  // of watched robots
  std::vector<Slot> slots_;
  Slot everybody_;
  std::vector<Level> own_;
  std::vector<Level> link_;
  Level all_;
  std::vector<Severity> severities_;
  Severity worst_ = Severity::kNone;
  std::vector<Reaction> begun_;
  ReactionCounters counters_;
  Time last_{0};
  bool has_begun_ = false;
};

}  // namespace mayfly
