// The invariants, asserted on every tick by somebody who does not trust the governor: it looks at what is
// about to be sent, and works the rest out anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "controller/estimator/estimator.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/guard/fence_watch.hpp"
#include "controller/guard/invariants.hpp"
#include "controller/guard/separation_watch.hpp"
#include "controller/life_cycle/robot_state.hpp"
#include "core/hal.hpp"

namespace mayfly {

// What only others can see. Empty: that is not watched. Called in the tick: they allocate, block and throw
// nothing.
struct MonitorHooks {
  std::function<std::uint64_t()> allocations;  // in ticks so far, and calls that may block
  std::function<bool()> owns_commands;         // nobody else commands these robots
};

struct MonitorConfig {
  Time period{0};
  Time most_command_life{0};  // deadlines lie no farther ahead
  Time tick_budget{0};        // 0: not watched (a virtual clock)
  Box fence;                  // m
  std::vector<HalfSpace> half_spaces;
  std::vector<GovernorGroup> groups;  // cover the robots; those with `enabled` false: finite and speed only
  MonitorHooks hooks;
};

// All that a tick came to. One element a robot in each column.
struct TickOutcome {
  Time now{0};
  CommandColumns commands;  // as they will be written
  EstimateColumns estimate;
  std::span<const RobotState> states;
  std::span<const Severity> severities;
  std::span<const std::uint8_t> ours;  // 0: the robot is absent, or not governed now: it reserves nothing
  std::span<const Symptoms> governed;  // what the governor saw of each: kTrackingError is I7
  bool acknowledged = false;           // an operator acknowledged since the last tick
};

class Monitor {
 public:
  explicit Monitor(MonitorConfig config);

  // Sequences begin anew, and nothing of before counts.
  void reset() noexcept;

  // Before anything is written.
  void check(const TickOutcome& tick) noexcept;
  // What the HAL made of it: a robot that was told something else is a breach of this tick.
  void wrote(const HalResult& result) noexcept;
  // How long the tick took, when it is over; judged with the next check.
  void took(Time duration) noexcept { took_ = duration; }

  // False only for what is no number or no command at all: everything else is safer sent than silence.
  bool may_send(std::size_t robot) const noexcept { return is_finite_[robot] != 0; }
  // Breaches of the last check, as symptoms.
  std::span<const Symptoms> symptoms() const noexcept { return symptoms_; }
  Symptoms everybody() const noexcept { return everybody_; }
  // Whether all held at the last check: only then a watchdog is fed (I17).
  bool held() const noexcept { return held_; }
  const InvariantCounters& counters() const noexcept { return counters_; }

 private:
  struct Limits {
    double speed = 0.0, change = 0.0, braking = 0.0, radius = 0.0, response_time = 0.0, downwash = 1.0;
    bool governed = true;
  };
  // What was sent last, m/s; not known before the first command and after one that was not ours.
  struct Sent {
    glm::dvec3 velocity{0.0};
    bool known = false;
  };

  bool has_one_each(const CommandColumns& commands) const noexcept;
  void breach(Invariant invariant) noexcept;
  void breach(Invariant invariant, std::size_t robot) noexcept;
  void check_command(const TickOutcome& tick, std::size_t robot) noexcept;
  void check_motion(const TickOutcome& tick, std::size_t robot, const glm::dvec3& velocity) noexcept;
  void check_life(const TickOutcome& tick, std::size_t robot) noexcept;
  void check_space(const TickOutcome& tick) noexcept;
  void check_tick(const TickOutcome& tick) noexcept;
  StoppingPath path_of(const TickOutcome& tick, std::size_t robot) const noexcept;

  MonitorConfig config_;
  double period_ = 0.0;  // s
  std::vector<Limits> limits_;
  std::vector<Sent> sent_;
  std::vector<RobotState> states_;
  std::vector<Severity> severities_;
  std::vector<StoppingPath> paths_;
  std::vector<std::uint8_t> is_finite_;
  std::vector<Symptoms> symptoms_;
  SeparationWatch separation_;
  FenceWatch fence_;
  Symptoms everybody_;
  std::uint64_t sequence_ = 0;
  std::uint64_t allocations_ = 0;
  bool has_begun_ = false;
  bool held_ = true;
  Time took_{0};
  InvariantCounters counters_;
};

}  // namespace mayfly
