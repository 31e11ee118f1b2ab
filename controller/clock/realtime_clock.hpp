// The clock of a run beside the real world.
#pragma once

#include "core/clock.hpp"

namespace mayfly {

// CLOCK_MONOTONIC, counted from construction unless told otherwise: a jump of the wall clock cannot move a
// robot. Sleeps are absolute, so a late wake-up never shifts the next one. Thread-safe.
class RealtimeClock final : public Clock {
 public:
  RealtimeClock() noexcept;
  // Counted from `start` on CLOCK_MONOTONIC: two processes that are told the same start tell the same time.
  explicit RealtimeClock(Time start) noexcept : start_(start) {}
  Time start() const noexcept { return start_; }
  Time now() const noexcept override;
  // Signals do not cut the sleep short: who must stop earlier looks at its stop flag after the next release.
  void sleep_until(Time deadline) noexcept override;
  bool is_virtual() const noexcept override { return false; }

 private:
  Time start_;
};

}  // namespace mayfly
