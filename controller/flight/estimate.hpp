// What is known of every robot: the newest sample that made sense, and how old it is.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/hal.hpp"

namespace mayfly {

class Estimate {
 public:
  explicit Estimate(std::size_t agents)
      : x(agents, kUnknown),
        y(agents, kUnknown),
        z(agents, kUnknown),
        vx(agents),
        vy(agents),
        vz(agents),
        stamp(agents),
        valid(agents),
        fresh(agents),
        sample_(agents) {}

  // One element an agent; m, m/s, world frame. valid: 0 until the first good sample, and no place is known
  // till then. fresh: 1 where the last update took a sample.
  std::vector<float> x, y, z, vx, vy, vz;
  std::vector<Time> stamp;
  std::vector<std::uint8_t> valid, fresh;

  // Where the HAL writes this tick's samples.
  StateColumns inbox() {
    return {sample_.x,  sample_.y,  sample_.z,     sample_.vx,
            sample_.vy, sample_.vz, sample_.stamp, sample_.valid};
  }

  // Takes the samples over. One that is not valid or not a number is dropped, and the robot keeps its last
  // state with its old stamp: whoever flies by it sees its age. Returns the first robot whose sample claimed
  // to be valid and held a NaN or an infinity, if any did.
  std::optional<RobotIndex> update() noexcept {
    std::optional<RobotIndex> liar;
    for (std::size_t a = 0; a < x.size(); ++a) {
      fresh[a] = 0;
      if (sample_.valid[a] == 0) {
        continue;
      }
      if (!is_finite(a)) {
        liar = liar.value_or(static_cast<RobotIndex>(a));
        continue;
      }
      x[a] = sample_.x[a];
      y[a] = sample_.y[a];
      z[a] = sample_.z[a];
      vx[a] = sample_.vx[a];
      vy[a] = sample_.vy[a];
      vz[a] = sample_.vz[a];
      stamp[a] = sample_.stamp[a];
      valid[a] = 1;
      fresh[a] = 1;
    }
    return liar;
  }

 private:
  static constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

  bool is_finite(std::size_t a) const {
    return std::isfinite(sample_.x[a]) && std::isfinite(sample_.y[a]) && std::isfinite(sample_.z[a]) &&
           std::isfinite(sample_.vx[a]) && std::isfinite(sample_.vy[a]) && std::isfinite(sample_.vz[a]);
  }

  struct Sample {
    explicit Sample(std::size_t n) : x(n), y(n), z(n), vx(n), vy(n), vz(n), stamp(n), valid(n) {}
    std::vector<float> x, y, z, vx, vy, vz;
    std::vector<Time> stamp;
    std::vector<std::uint8_t> valid;
  };
  Sample sample_;
};

}  // namespace mayfly
