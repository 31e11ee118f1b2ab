// When plant steps happen: exact integers, so that a run of hours drifts by nothing.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/clock.hpp"

namespace mayfly::sim_hal {

// Step k begins k periods after the origin, rounded up to a whole nanosecond. The rate is held in mHz,
// because most periods (1/300 s) are no whole number of nanoseconds.
class StepClock {
 public:
  static constexpr double kSlowestHz = 1.0;
  static constexpr double kFastestHz = 5000.0;  // keeps every product below within 64 bits

  StepClock() = default;
  StepClock(Time origin, double rate_hz)
      : origin_ns_(origin.count()), rate_mhz_(static_cast<std::int64_t>(std::llround(rate_hz * 1e3))) {}

  // How many whole steps lie between the origin and `now`; 0 before the origin.
  std::int64_t steps_at(Time now) const noexcept {
    const std::int64_t elapsed = now.count() - origin_ns_;
    if (elapsed <= 0) {
      return 0;
    }
    const std::int64_t millisteps = elapsed / kSecond * rate_mhz_;
    return millisteps / 1000 + (millisteps % 1000 * kSecond + elapsed % kSecond * rate_mhz_) / kNsMilli;
  }
  // When step k begins: the earliest time at which steps_at() is k.
  Time time_of(std::int64_t step) const noexcept {
    const std::int64_t rest = step % rate_mhz_ * kNsMilli;
    return Time(origin_ns_ + step / rate_mhz_ * kNsMilli + (rest + rate_mhz_ - 1) / rate_mhz_);
  }
  // The first step that begins at `now` or later.
  std::int64_t first_step_from(Time now) const noexcept {
    return now.count() <= origin_ns_ ? 0 : steps_at(now - Time(1)) + 1;
  }

 private:
  static constexpr std::int64_t kSecond = 1'000'000'000;
  static constexpr std::int64_t kNsMilli = 1000 * kSecond;  // ns a second, times mHz a Hz

  std::int64_t origin_ns_ = 0;
  std::int64_t rate_mhz_ = 1000;
};

}  // namespace mayfly::sim_hal
