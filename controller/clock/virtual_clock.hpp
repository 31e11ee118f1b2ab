// The clock of a run that goes as fast as the machine can and gives the same bits every time.
#pragma once

#include <atomic>

#include "core/clock.hpp"

namespace mayfly {

// Time passes only in sleep_until, which jumps. Any thread may ask the time; one thread may sleep.
class VirtualClock final : public Clock {
 public:
  Time now() const noexcept override { return Time(now_.load(std::memory_order_relaxed)); }
  void sleep_until(Time deadline) noexcept override {
    if (deadline > now()) {
      now_.store(deadline.count(), std::memory_order_relaxed);
    }
  }
  bool is_virtual() const noexcept override { return true; }

 private:
  std::atomic<Time::rep> now_{0};
};

}  // namespace mayfly
