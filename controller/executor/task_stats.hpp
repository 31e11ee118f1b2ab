// What a task is told when it runs, and what is known of it afterwards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "controller/executor/latency_histogram.hpp"
#include "core/clock.hpp"

namespace mayfly {

// What a task is told each time it runs. Times are on the executor's clock.
struct TickInfo {
  std::uint64_t release = 0;  // number of this release since the start; skipped ones are counted in it
  std::uint64_t skipped = 0;  // releases just before this one that were skipped
  Time scheduled{0};          // start + release · period
  Time started{0};            // when the task was entered: scheduled, or later
  Time period{0};
};

struct TaskStats {
  std::string name;
  bool own_thread = false;  // a planner: beside control, not in its thread
  double rate_hz = 0.0;
  std::uint64_t ticks = 0;   // times the task ran
  std::uint64_t missed = 0;  // releases that were skipped, or whose work ended after the next release
  std::uint64_t missed_by_machine =
      0;                      // of these, where we slept in time and only the late wake-up made us miss
  std::uint64_t skipped = 0;  // of `missed`, those that never ran
  std::optional<Percentiles> jitter;  // µs from scheduled to started; 0 by construction on a virtual clock
  std::optional<Percentiles> run;     // µs of real time in the task, on either clock
};

}  // namespace mayfly
