// How late this machine wakes a thread that does nothing but sleep: what of our lateness is not ours.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>

#include "controller/executor/latency_histogram.hpp"
#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

// When the control thread worked last. Written by it, read by the witness.
class WorkMark {
 public:
  void begin(Time now) noexcept {
    // In this order, so that whoever reads in between sees work that has not ended.
    ended_.store(Time::max().count(), std::memory_order_relaxed);
    began_.store(now.count(), std::memory_order_release);
  }
  void end(Time now) noexcept { ended_.store(now.count(), std::memory_order_release); }
  bool covers(Time moment) const noexcept {
    return began_.load(std::memory_order_acquire) <= moment.count() &&
           moment.count() <= ended_.load(std::memory_order_acquire);
  }

 private:
  std::atomic<Time::rep> began_{Time::max().count()};
  std::atomic<Time::rep> ended_{Time::min().count()};
};

// Sleeps beside the control thread, at its rate and halfway between its releases; with its priority, and on
// its processor, where it has one. A moment at which control was at work tells of us, not of the machine, and
// is set aside.
class Witness {
 public:
  explicit Witness(const WorkMark& control) : control_(control) {}
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  ~Witness() { stop(); }

  struct Place {
    int priority = 0;  // SCHED_FIFO; 0: an ordinary thread
    int cpu = -1;      // -1: wherever the system likes
  };
  // Fails where there is no thread to be had.
  Result<void> start(Clock& clock, Time start, Time period, const Place& place);
  // Returns within a period and 10 ms. Idempotent.
  void stop() noexcept;

  // Sleeps to the next moment start + (k + ½)·period and records how late it was woken.
  void look(Clock& clock, Time start, Time period) noexcept;

  // µs from when it asked to be woken; not before stop(). Empty: nothing was measured.
  std::optional<Percentiles> oversleep() const { return oversleep_.percentiles(); }
  std::uint64_t set_aside() const { return set_aside_; }

 private:
  const WorkMark& control_;
  LatencyHistogram oversleep_;
  std::uint64_t set_aside_ = 0;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

}  // namespace mayfly
