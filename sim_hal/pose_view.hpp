// All robots' true motion at one plant step.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/clock.hpp"

namespace mayfly::sim_hal {

// Positions in m, velocities in m/s, world frame; one element a robot in each column.
struct PoseView {
  std::array<std::span<const float>, 6> columns;  // x, y, z, vx, vy, vz
  std::span<const std::uint8_t> airborne;         // 0: it has landed
  Time stamp{0};
  std::int64_t step = -1;  // of the plants; -1 is "none yet"
};

// The same with memory of its own.
class PoseSample {
 public:
  explicit PoseSample(std::size_t robots = 0) : robots_(robots), values_(6 * robots), airborne_(robots) {}

  // `from` has as many robots. Allocates nothing.
  void copy(const PoseView& from) noexcept {
    for (std::size_t c = 0; c < 6; ++c) {
      std::copy(from.columns[c].begin(), from.columns[c].end(), column(c).begin());
    }
    std::copy(from.airborne.begin(), from.airborne.end(), airborne_.begin());
    stamp_ = from.stamp;
    step_ = from.step;
  }
  PoseView view() const noexcept {
    PoseView view{{}, airborne_, stamp_, step_};
    for (std::size_t c = 0; c < 6; ++c) {
      view.columns[c] = {values_.data() + c * robots_, robots_};
    }
    return view;
  }
  std::span<float> column(std::size_t c) noexcept { return {values_.data() + c * robots_, robots_}; }

 private:
  std::size_t robots_;
  std::vector<float> values_;
  std::vector<std::uint8_t> airborne_;
  Time stamp_{0};
  std::int64_t step_ = -1;
};

}  // namespace mayfly::sim_hal
