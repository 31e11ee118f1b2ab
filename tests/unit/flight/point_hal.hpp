// A HAL of points that obey at once, which writes down what it is told and fails as a test tells it to.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/hal.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {

class PointHal final : public Hal {
 public:
  explicit PointHal(std::vector<glm::vec3> places) : at_(std::move(places)), velocity_(at_.size()) {
    for (std::size_t robot = 0; robot < at_.size(); ++robot) {
      infos_.push_back({"point_" + std::to_string(robot), "wire"});
    }
  }
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "points"; }

  // What goes wrong.
  bool configure_fails = false, activate_fails = false, deactivate_fails = false;
  std::vector<RobotIndex> silent;  // their samples are never valid
  std::vector<RobotIndex> lying;   // their samples are NaN and claim to be valid
  HalResult read_result, write_result;
  std::uint64_t read_fails_from = 0, read_fails_before = 0;  // read_result's ticks

  // What it was told, one element a tick.
  struct Written {
    Time now, deadline;
    std::uint64_t sequence;
    std::vector<CommandKind> kinds;
    std::vector<glm::vec3> velocities;
  };
  std::vector<Written> written;
  int deactivated = 0;

  const std::vector<glm::vec3>& places() const { return at_; }

 private:
  static Result<void> answer(bool fails, const char* what) {
    return fails ? Result<void>(fail(Cause::kDevice, what)) : Result<void>();
  }
  Result<void> do_configure() override { return answer(configure_fails, "no such dongle"); }
  Result<void> do_activate(Time) override { return answer(activate_fails, "rotors are off"); }
  Result<void> do_deactivate(Time) override { return ++deactivated, answer(deactivate_fails, "won't land"); }

  HalResult do_read(Time now, const StateColumns& to) noexcept override {
    const auto passed = static_cast<float>(to_seconds(now - last_));
    last_ = now;
    for (std::size_t robot = 0; robot < at_.size(); ++robot) {
      at_[robot] += passed * velocity_[robot];
      to.x[robot] = at_[robot].x;
      to.y[robot] = at_[robot].y;
      to.z[robot] = at_[robot].z;
      to.vx[robot] = velocity_[robot].x;
      to.vy[robot] = velocity_[robot].y;
      to.vz[robot] = velocity_[robot].z;
      to.stamp[robot] = now;
      to.valid[robot] = 1;
    }
    for (const RobotIndex robot : silent) {
      to.valid[robot] = 0;
    }
    for (const RobotIndex robot : lying) {
      to.y[robot] = std::numeric_limits<float>::quiet_NaN();
    }
    const std::uint64_t tick = reads_++;
    return tick >= read_fails_from && tick < read_fails_before ? read_result : HalResult{};
  }

  HalResult do_write(Time now, const CommandColumns& commands) noexcept override {
    Written& tick = written.emplace_back();
    tick = {now, commands.deadline, commands.sequence, {commands.kind.begin(), commands.kind.end()}, {}};
    for (std::size_t robot = 0; robot < at_.size(); ++robot) {
      const bool flies = commands.kind[robot] == CommandKind::kVelocity;
      velocity_[robot] =
          flies ? glm::vec3(commands.vx[robot], commands.vy[robot], commands.vz[robot]) : glm::vec3(0.0F);
      tick.velocities.push_back(velocity_[robot]);
    }
    return write_result;
  }

  std::vector<glm::vec3> at_, velocity_;
  std::vector<RobotInfo> infos_;
  Time last_{0};
  std::uint64_t reads_ = 0;
};

}  // namespace mayfly::test
