// The recent past, for a HAL that tells the state as it was a while ago.
#pragma once

#include <cstddef>
#include <vector>

#include "sim_hal/pose_view.hpp"

namespace mayfly::sim_hal {

class PoseRing {
 public:
  PoseRing(std::size_t capacity, std::size_t robots) : samples_(capacity, PoseSample(robots)) {}

  void clear() noexcept { count_ = 0; }
  // Forgets the oldest where it is full. A step that is already there is not kept twice.
  void push(const PoseView& sample) noexcept {
    if (count_ > 0 && at_age(0).view().step >= sample.step) {
      return;
    }
    newest_ = (newest_ + 1) % samples_.size();
    samples_[newest_].copy(sample);
    count_ = count_ < samples_.size() ? count_ + 1 : count_;
  }
  // The newest that was measured at `time` or before; one with step -1 if there is none.
  PoseView newest_at(Time time) const noexcept {
    for (std::size_t age = 0; age < count_; ++age) {
      const PoseView view = at_age(age).view();
      if (view.stamp <= time) {
        return view;
      }
    }
    return {};
  }

 private:
  const PoseSample& at_age(std::size_t age) const noexcept {
    return samples_[(newest_ + samples_.size() - age) % samples_.size()];
  }

  std::vector<PoseSample> samples_;
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace mayfly::sim_hal
