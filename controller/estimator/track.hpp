// One robot's filter with its recent past, so that a sample that comes late goes in where it belongs.
#pragma once

#include <cstddef>
#include <span>

#include "controller/estimator/motion_filter.hpp"
#include "core/clock.hpp"

namespace mayfly::estimator {

// A sample and what was believed once it was taken.
struct Step {
  Time stamp{0};
  Measurement measurement;
  Belief belief;
};

// Remembers as many samples as it is given room for, at least one. Allocates nothing.
class Track {
 public:
  explicit Track(std::span<Step> room) : steps_(room) {}

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
  Step& at(std::size_t index) noexcept { return steps_[(first_ + index) % steps_.size()]; }
  const Step& at(std::size_t index) const noexcept { return steps_[(first_ + index) % steps_.size()]; }

  std::span<Step> steps_;  // a ring, in the order of stamps
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace mayfly::estimator
