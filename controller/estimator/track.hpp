// One robot's filter with its recent past, so that a sample that comes late goes in where it belongs.
#pragma once

#include <array>
#include <cstddef>

#include "controller/estimator/motion_filter.hpp"
#include "core/clock.hpp"

namespace mayfly::estimator {

// A sample and what was believed once it was taken.
struct Step {
  Time stamp{0};
  Measurement measurement;
  Belief belief;
};

// Remembers so many samples. Allocates nothing.
class Track {
 public:
  static constexpr std::size_t kSteps = 16;

  bool has_begun() const noexcept { return count_ > 0; }
  // Forgets what was before.
  void begin(Time stamp, const Measurement& first, double most_speed) noexcept;
  // The newest step that is no younger than `stamp`; null where all that are remembered are younger.
  const Step* before(Time stamp) const noexcept;
  // `before(stamp)` is not null. One that is not the newest is put in its place, and those after it are taken
  // once more.
  void take(Time stamp, const Measurement& measurement, double density) noexcept;
  // Has begun.
  const Step& newest() const noexcept { return at(count_ - 1); }

 private:
  Step& at(std::size_t index) noexcept { return steps_[(first_ + index) % kSteps]; }
  const Step& at(std::size_t index) const noexcept { return steps_[(first_ + index) % kSteps]; }

  std::array<Step, kSteps> steps_;  // a ring, in the order of stamps
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace mayfly::estimator
