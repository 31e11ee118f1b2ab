// What every HAL must do, whatever its robots are. A HAL's own tests instantiate it:
//
//   INSTANTIATE_TEST_SUITE_P(MyHal, HalContract, ::testing::Values(HalFactory{"mine", [](std::size_t robots)
//   {…}}), name_of);
//
// Time is what the tests say it is: the HAL must run in lock step.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/hal.hpp"

namespace mayfly::contract {

struct HalFactory {
  std::string name;
  // A new HAL, in the state in which it is constructed, with so many robots.
  std::function<std::unique_ptr<Hal>(std::size_t robots)> make;
  // After this long without a valid command a robot stands still.
  Time settling = std::chrono::seconds(10);
};

inline void PrintTo(const HalFactory& factory, std::ostream* stream) {
  *stream << factory.name;
}
inline std::string name_of(const ::testing::TestParamInfo<HalFactory>& info) {
  return info.param.name;
}

// Columns for `robots` robots, with memory of their own.
struct States {
  explicit States(std::size_t robots)
      : x(robots),
        y(robots),
        z(robots),
        vx(robots),
        vy(robots),
        vz(robots),
        stamp(robots),
        valid(robots),
        telemetry(robots) {}
  StateColumns columns() { return {x, y, z, vx, vy, vz, stamp, valid, telemetry}; }
  float speed(std::size_t robot) const { return std::hypot(vx[robot], vy[robot], vz[robot]); }
  std::vector<float> x, y, z, vx, vy, vz;
  std::vector<Time> stamp;
  std::vector<std::uint8_t> valid;
  std::vector<Telemetry> telemetry;
};

struct Commands {
  explicit Commands(std::size_t robots, CommandKind every = CommandKind::kVelocity)
      : kind(robots, every), vx(robots, 1.0F), vy(robots), vz(robots) {}
  CommandColumns columns(Time deadline, std::uint64_t sequence) const {
    return {kind, vx, vy, vz, deadline, sequence};
  }
  std::vector<CommandKind> kind;
  std::vector<float> vx, vy, vz;
};

class HalContract : public ::testing::TestWithParam<HalFactory> {
 protected:
  static constexpr Time kStep = std::chrono::milliseconds(10);
  static constexpr Time kStart = std::chrono::seconds(3);  // no clock needs to begin at 0

  void make(std::size_t robots) {
    hal_ = GetParam().make(robots);
    ASSERT_NE(hal_, nullptr);
    states_ = States(robots);
    commands_ = Commands(robots);
  }
  void make_active(std::size_t robots) {
    make(robots);
    ASSERT_TRUE(hal_->configure().has_value());
    ASSERT_TRUE(hal_->activate(now_).has_value());
    ASSERT_EQ(hal_->robots().size(), robots);
  }
  HalResult read() { return hal_->read(now_, states_.columns()); }
  HalResult write(Time deadline) { return hal_->write(now_, commands_.columns(deadline, ++sequence_)); }
  HalResult write() { return write(now_ + 20 * kStep); }
  // Control as usual: read, write, some time.
  void fly(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      ASSERT_TRUE(read().ok());
      ASSERT_TRUE(write().ok());
      now_ += kStep;
    }
  }
  // Nobody writes any more; reads go on.
  void drift(Time duration) {
    for (const Time end = now_ + duration; now_ < end; now_ += kStep) {
      ASSERT_TRUE(read().ok());
    }
    ASSERT_TRUE(read().ok());
  }
  std::uint64_t refused_calls() const { return hal_->counters().refused_calls; }
  std::uint64_t refused_commands() const { return hal_->counters().refused_commands; }

  std::unique_ptr<Hal> hal_;
  States states_{0};
  Commands commands_{0};
  Time now_ = kStart;
  std::uint64_t sequence_ = 0;
};

}  // namespace mayfly::contract
