// An estimator whose samples a test writes by hand.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include "controller/estimator/estimator.hpp"

namespace mayfly::estimator_test {

using Vec = std::array<double, 3>;

inline constexpr Time kPeriod = std::chrono::milliseconds(10);

// Robots that can do 3 m/s and 20 m/s², measured at each tick; poses older than 50 ms are stale.
inline EstimatorConfig config_of(std::size_t robots, float pose_noise = 0.0F) {
  EstimatorConfig config;
  config.period = kPeriod;
  config.most_age = 5 * kPeriod;
  config.sources[0].pose_noise = pose_noise;
  config.sources[0].takes_velocity = pose_noise <= 0.0F;
  config.robots.resize(robots);
  return config;
}

class Rig {
 public:
  explicit Rig(EstimatorConfig config)
      : estimator(make(config)),
        kind_(config.robots.size(), CommandKind::kHold),
        vx_(config.robots.size()),
        vy_(vx_),
        vz_(vx_) {}

  // A sample of `now`, or of another time.
  void put(std::size_t robot, Vec place, Vec velocity = {}) { put_at(robot, place, velocity, now); }
  void put_at(std::size_t robot, Vec place, Vec velocity, Time stamp, std::size_t source = 0) {
    const StateColumns in = estimator.inbox(source);
    in.x[robot] = static_cast<float>(place[0]);
    in.y[robot] = static_cast<float>(place[1]);
    in.z[robot] = static_cast<float>(place[2]);
    in.vx[robot] = static_cast<float>(velocity[0]);
    in.vy[robot] = static_cast<float>(velocity[1]);
    in.vz[robot] = static_cast<float>(velocity[2]);
    in.stamp[robot] = stamp;
    in.valid[robot] = 1;
  }
  void lose(std::size_t robot, std::size_t source = 0) { estimator.inbox(source).valid[robot] = 0; }
  // From the next tick on it is told this, or to hold.
  void tell(std::size_t robot, Vec velocity) {
    kind_[robot] = CommandKind::kVelocity;
    vx_[robot] = static_cast<float>(velocity[0]);
    vy_[robot] = static_cast<float>(velocity[1]);
    vz_[robot] = static_cast<float>(velocity[2]);
  }
  void tell_hold(std::size_t robot) { kind_[robot] = CommandKind::kHold; }

  // What stands in the inboxes is taken, the commands are sent, and the next tick begins.
  void tick() {
    estimator.update(now);
    estimator.sent(now, {kind_, vx_, vy_, vz_, now + 5 * kPeriod, ++sequence_});
    now += kPeriod;
  }

  bool has(std::size_t robot, Symptom symptom) const {
    return estimator.estimate().symptoms[robot].has(symptom);
  }
  bool known(std::size_t robot) const { return estimator.estimate().known[robot] != 0; }
  Vec place(std::size_t robot) const {
    const EstimateColumns e = estimator.estimate();
    return {static_cast<double>(e.x[robot]), static_cast<double>(e.y[robot]),
            static_cast<double>(e.z[robot])};
  }
  Vec velocity(std::size_t robot) const {
    const EstimateColumns e = estimator.estimate();
    return {static_cast<double>(e.vx[robot]), static_cast<double>(e.vy[robot]),
            static_cast<double>(e.vz[robot])};
  }
  std::uint64_t count(SampleFate fate) const { return estimator.counters().of(fate); }

  Estimator estimator;
  Time now = std::chrono::seconds(2);  // no clock needs to begin at 0

 private:
  static Estimator make(const EstimatorConfig& config) {
    auto made = Estimator::create(config);
    return std::move(made.value());
  }

  std::vector<CommandKind> kind_;
  std::vector<float> vx_, vy_, vz_;
  std::uint64_t sequence_ = 0;
};

}  // namespace mayfly::estimator_test
