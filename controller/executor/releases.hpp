// One task's releases: when it is due, what it misses and by whose fault, and how long it works.
#pragma once

#include <cstdint>
#include <string>

#include "controller/executor/latency_histogram.hpp"
#include "controller/executor/task_stats.hpp"
#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

// The last time a thread had nothing to do, relative to the start of the run.
struct Sleep {
  Time began{0};
  Time ended{0};
};

// Releases at k·period, on integer nanoseconds, so that nothing drifts. A task is never run twice to catch
// up: a release whose deadline (the next release) has passed is skipped and counted as missed. All times are
// relative to the start of the run.
class Releases {
 public:
  // `rate_hz` in [0.001, 100 000]; fails for another.
  static Result<Releases> make(std::string name, double rate_hz);

  const std::string& name() const noexcept { return name_; }
  Time period() const noexcept { return period_; }
  Time scheduled() const noexcept { return period_ * static_cast<Time::rep>(next_); }
  Time deadline() const noexcept { return period_ * static_cast<Time::rep>(next_ + 1); }
  bool is_due(Time now, Time duration) const noexcept { return scheduled() <= now && scheduled() < duration; }

  // Release 0 is next; the statistics go on.
  void restart() noexcept;
  void skip_expired(Time now, Time duration, const Sleep& sleep) noexcept;
  // The next release begins at `now`, in a run that began at `start`.
  TickInfo begin(Time start, Time now) const noexcept;
  // It has ended at `ended`, after `worked` of real time.
  void end(Time began, Time ended, Time worked, const Sleep& sleep) noexcept;

  TaskStats stats() const;

 private:
  Releases(std::string name, double rate_hz);
  void count_if_late(Time ended, const Sleep& sleep) noexcept;

  std::string name_;
  double rate_hz_;
  Time period_;
  std::uint64_t next_ = 0;  // the release that is awaited or due
  std::uint64_t skipped_before_next_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint64_t missed_ = 0;
  std::uint64_t missed_by_machine_ = 0;
  std::uint64_t skipped_ = 0;
  LatencyHistogram jitter_;
  LatencyHistogram run_;
};

// The work's own duration, also where the run's clock stands still.
Time real_now() noexcept;

}  // namespace mayfly
