// Robots that obey at once, a guard before them, and ticks of both.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "controller/guard/guard.hpp"
#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {

// In the order of robots, on two links: the last robot has one for itself.
class Robots final : public Hal {
 public:
  explicit Robots(std::vector<glm::vec3> places)
      : at(std::move(places)), velocity(at.size()), wind(at.size()), mute(at.size()) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      infos_.push_back({"robot_" + std::to_string(i), i + 1 < at.size() ? "first" : "second"});
    }
    kind.assign(at.size(), CommandKind::kNone);
    telemetry.resize(at.size());
  }
  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return "robots"; }

  std::vector<glm::vec3> at, velocity;
  std::vector<glm::vec3> wind;     // m/s, beside what it is told
  std::vector<std::uint8_t> mute;  // 1: no pose comes of it
  std::vector<Telemetry> telemetry;
  std::vector<CommandKind> kind;  // as told last
  HalResult read_result, write_result;
  Time deadline{0};
  std::uint64_t sequence = 0;

 private:
  Result<void> do_configure() override { return {}; }
  Result<void> do_activate(Time now) override { return last_ = now, Result<void>(); }
  Result<void> do_deactivate(Time) override { return {}; }
  HalResult do_read(Time now, const StateColumns& to) noexcept override {
    const auto passed = static_cast<float>(to_seconds(now - last_));
    last_ = now;
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] += passed * (velocity[i] + wind[i]);
      if (!to.telemetry.empty()) {
        to.telemetry[i] = telemetry[i];
      }
      if (mute[i] != 0) {
        to.valid[i] = 0;
        continue;
      }
      to.x[i] = at[i].x;
      to.y[i] = at[i].y;
      to.z[i] = at[i].z;
      to.vx[i] = velocity[i].x + wind[i].x;
      to.vy[i] = velocity[i].y + wind[i].y;
      to.vz[i] = velocity[i].z + wind[i].z;
      to.stamp[i] = now;
      to.valid[i] = 1;
    }
    return read_result;
  }
  HalResult do_write(Time, const CommandColumns& c) noexcept override {
    for (std::size_t i = 0; i < at.size(); ++i) {
      kind[i] = c.kind[i];
      velocity[i] = c.kind[i] == CommandKind::kVelocity ? glm::vec3(c.vx[i], c.vy[i], c.vz[i]) : glm::vec3(0);
    }
    deadline = c.deadline;
    sequence = c.sequence;
    return write_result;
  }

  std::vector<RobotInfo> infos_;
  Time last_{0};
};

inline GuardConfig guard_of(std::size_t robots) {
  GuardConfig config;
  config.period = kTick;
  config.governor.period = kTick;
  config.governor.fence = {{0, 0, 0}, {20, 20, 20}};
  GovernorGroup group;
  group.count = robots;
  group.limits.speed = 2.0F;
  group.limits.acceleration = group.limits.braking = 4.0F;
  group.limits.radius = 0.1F;
  group.limits.tube = 0.05F;
  group.limits.follows = Follows::kAtOnce;
  config.governor.groups = {group};
  config.estimator.period = kTick;
  config.estimator.pose_period = kTick;
  config.estimator.most_age = 10 * kTick;
  config.estimator.most_ahead = kTick;
  config.estimator.robots.assign(robots, {2.0F, 4.0F, 0.0F});
  config.life_cycle.robots = robots;
  config.most_plan_age = 5 * kTick;
  config.command_life = config.governor.command_life = 5 * kTick;
  config.black_box.seconds = 1.0;
  return config;
}

struct FieldTrip {
  explicit FieldTrip(std::vector<glm::vec3> places) : FieldTrip(places, guard_of(places.size())) {}
  FieldTrip(const std::vector<glm::vec3>& places, GuardConfig config)
      : robots(places), wish(places.size(), {0, 0, 0}) {
    EXPECT_TRUE(robots.configure());
    auto made = Guard::create(std::move(config), robots);
    if (!made) {
      ADD_FAILURE() << to_string(made.error());
      std::abort();
    }
    guard = std::move(*made);
    EXPECT_TRUE(robots.activate(now));
  }

  // Hears, and hands a fresh wish over.
  HalResult tick() {
    now += kTick;
    guard->sense(now);
    return guard->act(now, wish.columns(now + 3 * kTick, ++sequence));
  }
  void fly(double seconds) {
    for (Time end = now + from_seconds(seconds); now < end;) {
      tick();
    }
  }
  // The planner says nothing new.
  void drift(double seconds) {
    for (Time end = now + from_seconds(seconds); now < end;) {
      now += kTick;
      guard->sense(now);
      guard->act(now, wish.columns(last_deadline, sequence));
    }
  }
  Severity severity(std::size_t robot) const { return guard->severities()[robot]; }
  float speed(std::size_t robot) const { return glm::length(robots.velocity[robot]); }

  Robots robots;
  WishOf wish;
  std::unique_ptr<Guard> guard;
  Time now{std::chrono::seconds(1)};
  Time last_deadline{0};
  std::uint64_t sequence = 0;
};

}  // namespace mayfly::test
