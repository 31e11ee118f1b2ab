// Stopping a flight: the first request holds the swarm until it stands still, the second ends all at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;

// Asks to stop as a signal handler would, at one tick or at two.
class StopAt final : public Observer {
 public:
  StopAt(StopRequest& stop, std::uint64_t first, std::uint64_t second = 1'000'000)
      : stop_(stop), first_(first), second_(second) {}
  void on_tick(const TickView& view) noexcept override {
    stop_ = view.tick >= second_ ? 2 : view.tick >= first_ ? 1 : 0;
    shown = {view.kind.begin(), view.kind.end()};
  }
  std::vector<CommandKind> shown;

 private:
  StopRequest& stop_;
  std::uint64_t first_, second_;
};

Scenario long_flight() {
  Scenario scenario = hall(5);
  scenario.duration = 60;
  return scenario;
}

TEST(Stop, HoldsEverybodyAndEndsWhenAllStandStill) {
  Sortie sortie(long_flight());
  StopAt stop(sortie.stop, 49);
  sortie.observers = {&stop};
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->stopped_by_user);
  EXPECT_THAT(sortie.hal.written.at(49).kinds, Each(CommandKind::kVelocity));
  // Asked after tick 49: from 50 on everybody brakes inside what it has reserved, at 20 m/s² from 3 m/s at
  // most, then holds.
  ASSERT_GE(summary->ticks, 51U);
  EXPECT_LE(summary->ticks, 70U);
  for (std::size_t tick = 50; tick < sortie.hal.written.size(); ++tick) {
    for (std::size_t robot = 0; robot < 5; ++robot) {
      const float before = glm::length(sortie.hal.written[tick - 1].velocities[robot]);
      const float speed = glm::length(sortie.hal.written[tick].velocities[robot]);
      EXPECT_LE(speed, std::max(0.0F, before - 0.2F + 1e-4F)) << tick;
    }
  }
  EXPECT_THAT(sortie.hal.written.back().kinds, Each(CommandKind::kHold));
  EXPECT_EQ(summary->safety.severity_max, "hold_all");
  EXPECT_THAT(stop.shown, Each(CommandKind::kHold)) << "what is recorded is what was written";
  EXPECT_EQ(sortie.hal.deactivated, 1);
  EXPECT_NEAR(summary->simulated_s, 0.01 * static_cast<double>(summary->ticks), 1e-9);
}

TEST(Stop, DoesNotWaitForEverForARobotThatDrifts) {
  Sortie sortie(long_flight());
  // A HAL of another make: its robots never stand still, whatever they are told.
  class Drifting final : public Hal {
   public:
    std::span<const RobotInfo> robots() const noexcept override { return infos_; }
    std::string_view name() const noexcept override { return "drifting"; }

   private:
    Result<void> do_configure() override { return {}; }
    Result<void> do_activate(Time) override { return {}; }
    Result<void> do_deactivate(Time) override { return {}; }
    HalResult do_read(Time now, const StateColumns& to) noexcept override {
      for (std::size_t robot = 0; robot < infos_.size(); ++robot) {
        to.x[robot] = 6;
        to.y[robot] = 3 + static_cast<float>(robot);
        to.z[robot] = 6;
        to.vx[robot] = 0.1F;
        to.vy[robot] = to.vz[robot] = 0;
        to.stamp[robot] = now;
        to.valid[robot] = 1;
      }
      return {};
    }
    HalResult do_write(Time, const CommandColumns&) noexcept override { return {}; }
    std::vector<RobotInfo> infos_ = std::vector<RobotInfo>(5);
  } drifting;
  StopAt stop(sortie.stop, 9);
  sortie.observers = {&stop};
  const auto summary = sortie.fly_with(drifting, *sortie.engine);
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->stopped_by_user);
  EXPECT_GE(summary->ticks, 210U);
  EXPECT_LE(summary->ticks, 215U);  // 2 s after it was asked
}

TEST(Stop, AskedTwiceStopsAtOnce) {
  Sortie sortie(long_flight());
  StopAt stop(sortie.stop, 1'000'000, 49);
  sortie.observers = {&stop};
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->stopped_by_user);
  ASSERT_EQ(sortie.hal.written.size(), 51U) << "one more tick, to say so";
  EXPECT_THAT(sortie.hal.written.back().kinds, Each(CommandKind::kStop));
}

TEST(Stop, AskedBeforeTheFirstTickFliesNowhere) {
  Sortie sortie(long_flight());
  sortie.stop = 1;
  const auto before = sortie.hal.places();
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_LE(summary->ticks, 2U);
  EXPECT_EQ(sortie.hal.places(), before);
}

}  // namespace
}  // namespace mayfly::test
