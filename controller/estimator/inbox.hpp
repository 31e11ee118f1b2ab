// Where a source writes its samples, and which of them are new.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "controller/estimator/pose_gate.hpp"
#include "core/hal.hpp"

namespace mayfly::estimator {

class Inbox {
 public:
  explicit Inbox(std::size_t n)
      : x_(n),
        y_(n),
        z_(n),
        vx_(n),
        vy_(n),
        vz_(n),
        stamp_(n),
        seen_(n, Time::min()),
        valid_(n),
        telemetry_(n) {
    for (Telemetry& telemetry : telemetry_) {
      telemetry.heard = Time::min();
    }
  }

  StateColumns columns() noexcept { return {x_, y_, z_, vx_, vy_, vz_, stamp_, valid_, telemetry_}; }
  const std::vector<Telemetry>& telemetry() const noexcept { return telemetry_; }

  // Whether there is a sample that was not there the last time this was asked.
  bool take_new(std::size_t i) noexcept {
    const bool is_new = valid_[i] != 0 && stamp_[i] != seen_[i];
    seen_[i] = is_new ? stamp_[i] : seen_[i];
    return is_new;
  }
  Time stamp(std::size_t i) const noexcept { return stamp_[i]; }
  Eigen::RowVector3d place(std::size_t i) const noexcept { return vector(x_[i], y_[i], z_[i]); }
  Eigen::RowVector3d velocity(std::size_t i) const noexcept { return vector(vx_[i], vy_[i], vz_[i]); }

 private:
  static Eigen::RowVector3d vector(float x, float y, float z) {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

  std::vector<float> x_, y_, z_, vx_, vy_, vz_;
  std::vector<Time> stamp_, seen_;
  std::vector<std::uint8_t> valid_;
  std::vector<Telemetry> telemetry_;
};

}  // namespace mayfly::estimator
