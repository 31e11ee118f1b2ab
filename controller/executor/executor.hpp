// Runs tasks at fixed rates in one thread, and measures how punctual they were.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "controller/executor/latency_histogram.hpp"
#include "core/clock.hpp"
#include "core/result.hpp"

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
  double rate_hz = 0.0;
  std::uint64_t ticks = 0;   // times the task ran
  std::uint64_t missed = 0;  // releases that were skipped, or whose work ended after the next release
  std::uint64_t missed_by_machine =
      0;                      // of these, where we slept in time and only the late wake-up made us miss
  std::uint64_t skipped = 0;  // of `missed`, those that never ran
  std::optional<Percentiles> jitter;  // µs from scheduled to started; 0 by construction on a virtual clock
  std::optional<Percentiles> run;     // µs of real time in the task, on either clock
};

// Releases each task at start + k·period, on integer nanoseconds, so that nothing drifts. Tasks that are due
// run one after the other, earliest deadline (the next release) first, then in the order they were added. A
// task is never run twice to catch up: a release whose deadline has passed is skipped and counted as missed.
//
// Work that would delay control (planners) belongs in a thread of its own that hands its results over through
// a mailbox; such tasks will be added here as another kind.
class Executor {
 public:
  explicit Executor(Clock& clock) : clock_(clock) {}

  // `rate_hz` in [0.001, 100 000]. `function` is called as void(const TickInfo&) and must be noexcept. Fails
  // for another rate or a name that is taken.
  template <class Function>
  Result<void> add_task(const std::string& name, double rate_hz, Function function) {
    static_assert(std::is_nothrow_invocable_v<Function&, const TickInfo&>,
                  "a task is called as void(const TickInfo&) noexcept");
    return add(name, rate_hz, std::move(function));
  }

  // Runs every release in [0, duration), then waits for the end of `duration`. Ends early, before the next
  // task, once `stop` is true: a signal handler may set it. Allocates nothing, throws nothing. May be called
  // again: release 0 is then the time of that call, and the statistics go on.
  void run(Time duration, const std::atomic<bool>& stop) noexcept;

  // One element a task, in the order they were added. Not while run() is running.
  std::vector<TaskStats> stats() const;

 private:
  struct Task {
    std::string name;
    double rate_hz = 0.0;
    Time period{0};
    std::function<void(const TickInfo&)> function;

    std::uint64_t next = 0;  // the release that is awaited or due
    std::uint64_t skipped_before_next = 0;

    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
    std::uint64_t missed_by_machine = 0;
    std::uint64_t skipped = 0;
    LatencyHistogram jitter;
    LatencyHistogram run;

    Time scheduled() const { return period * static_cast<Time::rep>(next); }
    Time deadline() const { return period * static_cast<Time::rep>(next + 1); }
  };

  // The last time the thread had nothing to do, relative to the start of the run.
  struct Sleep {
    Time began{0};
    Time ended{0};
  };

  Result<void> add(std::string name, double rate_hz, std::function<void(const TickInfo&)> function);
  Task* earliest_due(Time now, Time duration) noexcept;
  Time next_release(Time duration) const noexcept;
  void skip_expired(Task& task, Time now, Time duration) noexcept;
  void run_task(Task& task, Time start, Time now) noexcept;
  void count_if_late(Task& task, Time ended) noexcept;

  Clock& clock_;
  std::vector<Task> tasks_;
  Sleep sleep_;
};

}  // namespace mayfly
