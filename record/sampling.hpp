// Which control ticks a slower observer takes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mayfly::record {

// Takes ticks so that their rate is `wanted_hz`, evenly to within one tick, tick 0 first. In integers (of
// millihertz), so that a long flight drifts nowhere. Every tick, where more is wanted than there is.
class Sampling {
 public:
  Sampling(double wanted_hz, double control_hz)
      : control_(millihertz(control_hz)), wanted_(std::min(millihertz(wanted_hz), control_)) {}

  bool takes(std::uint64_t tick) const noexcept { return tick == 0 || due(tick) != due(tick - 1); }

 private:
  static std::uint64_t millihertz(double hertz) {
    return static_cast<std::uint64_t>(std::max(1.0, std::round(hertz * 1000.0)));
  }
  // Split so that no product overflows in any flight: tick = whole periods of the pattern and a rest.
  std::uint64_t due(std::uint64_t tick) const noexcept {
    return tick / control_ * wanted_ + tick % control_ * wanted_ / control_;
  }

  std::uint64_t control_;
  std::uint64_t wanted_;
};

}  // namespace mayfly::record
