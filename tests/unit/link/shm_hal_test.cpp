#include "controller/link/shm_hal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/link/link_pair.hpp"

namespace mayfly::link::test {
namespace {

using ::testing::HasSubstr;

constexpr Time kPeriod{10'000'000};
constexpr Time kNow{1'000'000'000};

// The planner's HAL over one link; the guard's end of it is the test's. The guard's process is this one,
// which does not end.
class Planner : public ::testing::Test {
 protected:
  Planner()
      : self_(*ProcessWatch::of(::getpid())),
        end_(*PlannerEnd::make(*Segment::create(roster_of(some_robots(kRobots)), Time(1)))),
        guard_(*GuardEnd::make(same_segment(end_.segment(), kRobots), Pair::kMostAge)),
        hal_({"guard", some_robots(kRobots), kPeriod, &asked_}, std::move(end_), self_) {}

  void fly() {
    guard_.set_phase(Phase::kReady);
    ASSERT_TRUE(hal_.configure());
    guard_.set_phase(Phase::kActive);
    ASSERT_TRUE(hal_.activate(kNow));
  }
  StateColumns columns() { return {x_, y_, z_, vx_, vy_, vz_, stamp_, valid_, telemetry_}; }
  HalResult read(Time now) { return hal_.read(now, columns()); }
  HalResult write(CommandKind kind, float vx, Time now) {
    const std::vector<CommandKind> kinds(kRobots, kind);
    const std::vector<float> column(kRobots, vx);
    return hal_.write(now, {kinds, column, column, column, now + 5 * kPeriod, ++sequence_});
  }

  static constexpr std::size_t kRobots = 3;
  std::atomic<int> asked_{0};
  ProcessWatch self_;
  PlannerEnd end_;
  GuardEnd guard_;
  ShmHal hal_;
  std::vector<float> x_ = std::vector<float>(kRobots), y_ = x_, z_ = x_, vx_ = x_, vy_ = x_, vz_ = x_;
  std::vector<Time> stamp_ = std::vector<Time>(kRobots);
  std::vector<std::uint8_t> valid_ = std::vector<std::uint8_t>(kRobots);
  std::vector<Telemetry> telemetry_ = std::vector<Telemetry>(kRobots);
  std::uint64_t sequence_ = 0;
};

TEST_F(Planner, ReadsTheGuardsEstimate) {
  fly();
  ViewColumns& view = guard_.view();
  view.x[1] = 2.0F;
  view.vz[1] = -1.0F;
  view.fresh[1] = 1;
  view.stamp_ns[1] = 77;
  view.battery[1] = 0.5F;
  view.x[2] = 9.0F;  // as it was a while ago
  guard_.show();
  EXPECT_TRUE(read(kNow).ok());
  EXPECT_EQ(valid_[1], 1);
  EXPECT_EQ(x_[1], 2.0F);
  EXPECT_EQ(vz_[1], -1.0F);
  EXPECT_EQ(stamp_[1], Time(77));
  EXPECT_EQ(telemetry_[1].battery, 0.5F);
  EXPECT_EQ(valid_[2], 0);
}

TEST_F(Planner, AnOldViewIsNotReadTwice) {
  fly();
  guard_.view().fresh[0] = 1;
  guard_.show();
  static_cast<void>(read(kNow));
  EXPECT_EQ(valid_[0], 1);
  static_cast<void>(read(kNow));
  EXPECT_EQ(valid_[0], 0);
}

TEST_F(Planner, WritesAWish) {
  fly();
  EXPECT_TRUE(write(CommandKind::kVelocity, 0.5F, kNow).ok());
  const CommandColumns wish = guard_.wish(kNow);
  EXPECT_EQ(wish.kind[0], CommandKind::kVelocity);
  EXPECT_EQ(wish.vy[2], 0.5F);
  EXPECT_EQ(wish.deadline, kNow + 5 * kPeriod);
  EXPECT_EQ(hal_.counters().misencoded, 0U);
}

// Each activation of a HAL begins its sequence anew; the link's goes on.
TEST_F(Planner, ASecondFlightIsHeardToo) {
  fly();
  static_cast<void>(write(CommandKind::kHold, 0.0F, kNow));
  static_cast<void>(write(CommandKind::kHold, 0.0F, kNow));
  const std::uint64_t before = guard_.wish(kNow).sequence;
  guard_.set_phase(Phase::kEnded);
  ASSERT_TRUE(hal_.deactivate(kNow));
  EXPECT_EQ(guard_.want(), Want::kEnd);
  ASSERT_TRUE(hal_.activate(kNow));
  sequence_ = 0;
  static_cast<void>(write(CommandKind::kHold, 0.0F, kNow));
  EXPECT_GT(guard_.wish(kNow).sequence, before);
}

TEST_F(Planner, AMissingHeartbeatIsTheLinksFault) {
  fly();
  guard_.show();
  EXPECT_TRUE(read(kNow).ok());
  // One step below the limit, and one beyond it.
  EXPECT_TRUE(read(kNow + 5 * kPeriod).ok());
  const HalResult down = read(kNow + 5 * kPeriod + Time(1));
  EXPECT_EQ(down.fault, HalFault::kLinkDown);
  EXPECT_EQ(down.robot, kEveryRobot);
  EXPECT_THAT(std::string(down.cause), HasSubstr("heartbeat"));
  EXPECT_EQ(write(CommandKind::kHold, 0.0F, kNow + 6 * kPeriod).fault, HalFault::kLinkDown);
  // It clears with the next beat, and ends no flight.
  guard_.show();
  EXPECT_TRUE(read(kNow + 7 * kPeriod).ok());
  EXPECT_EQ(hal_.stop(), 0);
}

TEST_F(Planner, AGuardThatEndedEndsTheFlight) {
  fly();
  guard_.show();
  EXPECT_TRUE(read(kNow).ok());
  EXPECT_FALSE(hal_.lost());
  hal_.guard_ended();
  EXPECT_TRUE(hal_.lost());
  const HalResult down = read(kNow);
  EXPECT_EQ(down.fault, HalFault::kLinkDown);
  EXPECT_THAT(std::string(down.cause), HasSubstr("their own watchdogs"));
  EXPECT_EQ(hal_.stop(), 2);
}

TEST_F(Planner, AGuardThatEndsAfterTheFlightIsNotLost) {
  fly();
  guard_.set_phase(Phase::kEnded);
  hal_.guard_ended();
  EXPECT_FALSE(hal_.lost());
}

TEST_F(Planner, RequestsToStopGoDownAsLevels) {
  fly();
  for (const int asked : {0, 1, 2, 3}) {
    asked_ = asked;
    hal_.ask_to_stop(asked);
    static_cast<void>(read(kNow));
    static_cast<void>(guard_.wish(kNow));
    EXPECT_EQ(static_cast<int>(guard_.stop()), std::min(asked, 2));
    EXPECT_EQ(hal_.stop(), asked);
  }
}

TEST_F(Planner, WhatHappenedAtTheGuardComesOutOfReadOnce) {
  fly();
  guard_.show();
  Event event{
      .time_ns = kNow.count(), .robot = 2, .fault = static_cast<std::uint32_t>(HalFault::kRobotSilent)};
  std::string("can0").copy(event.link.data(), event.link.size());
  std::string("no answer").copy(event.cause.data(), event.cause.size());
  guard_.tell(event);
  const HalResult told = read(kNow);
  EXPECT_EQ(told.fault, HalFault::kRobotSilent);
  EXPECT_EQ(told.robot, 2U);
  EXPECT_EQ(told.link, "can0");
  EXPECT_EQ(told.cause, "no answer");
  EXPECT_TRUE(read(kNow).ok());
}

TEST_F(Planner, HoldsUntilItHasDecidedSomething) {
  fly();
  const CommandColumns wish = guard_.wish(kNow);
  EXPECT_EQ(wish.kind[0], CommandKind::kHold);
  EXPECT_EQ(wish.deadline, kNow + Pair::kMostAge);
}

TEST_F(Planner, TellsWhatTheGuardMadeOfItsWish) {
  fly();
  guard_.view().kind[1] = static_cast<std::uint8_t>(CommandKind::kLand);
  guard_.view().kind[2] = 77;  // there is none such
  guard_.view().sent_vx[1] = 0.25F;
  guard_.view().severity[2] = static_cast<std::uint8_t>(Severity::kHold);
  guard_.view().report->wishes.refused = 5;
  guard_.show();
  static_cast<void>(read(kNow));
  EXPECT_EQ(hal_.written().kind[1], CommandKind::kLand);
  EXPECT_EQ(hal_.written().kind[2], CommandKind::kNone);
  EXPECT_EQ(hal_.written().vx[1], 0.25F);
  EXPECT_EQ(hal_.severity(), Severity::kHold);
  EXPECT_EQ(hal_.report().wishes.refused, 5U);
  guard_.view().severity[2] = 200;
  guard_.show();
  static_cast<void>(read(kNow));
  EXPECT_EQ(hal_.severity(), Severity::kCut);
}

TEST_F(Planner, KeepsTheGuardsReactions) {
  fly();
  Event event{.time_ns = 7, .robot = 1};
  event.symptom = static_cast<std::uint32_t>(Symptom::kSilent);
  event.severity = static_cast<std::uint32_t>(Severity::kHold);
  guard_.tell(event);
  event.symptom = 99;  // there is none such
  guard_.tell(event);
  guard_.view().head->reactions = 2;
  guard_.show();
  EXPECT_TRUE(read(kNow).ok());
  ASSERT_EQ(hal_.events().size(), 1U);
  EXPECT_EQ(hal_.events()[0].at, Time(7));
  EXPECT_EQ(hal_.events()[0].robot, 1U);
  EXPECT_EQ(hal_.events()[0].symptom, Symptom::kSilent);
  EXPECT_EQ(hal_.reactions(), 2U);
}

TEST_F(Planner, AnAcknowledgementGoesDown) {
  fly();
  hal_.acknowledge();
  static_cast<void>(guard_.wish(kNow));
  EXPECT_EQ(guard_.acknowledged(), 1U);
}

TEST_F(Planner, FaultsWithoutEndAreToldWithoutEnd) {
  fly();
  for (int kind = 0; kind < 300; ++kind) {
    Event event{.time_ns = kNow.count(), .robot = kEveryRobot, .fault = 99};
    std::to_string(kind).copy(event.cause.data(), event.cause.size());
    guard_.tell(event);
    guard_.show();
    EXPECT_EQ(read(kNow).fault, HalFault::kLinkDown);
  }
}

TEST_F(Planner, AStopWhileTheGuardStartsIsHeeded) {
  asked_ = 1;
  const auto configured = hal_.configure();
  ASSERT_FALSE(configured);
  EXPECT_THAT(configured.error().message, HasSubstr("stopped before"));
}

TEST_F(Planner, ASegmentForOtherRobotsIsRefused) {
  auto end = PlannerEnd::make(*Segment::create(roster_of(some_robots(2)), Time(1)));
  ShmHal hal({"guard", some_robots(3), kPeriod, nullptr}, std::move(*end), self_);
  EXPECT_THAT(hal.configure().error().message, HasSubstr("for 2 robots, not for 3"));
}

}  // namespace
}  // namespace mayfly::link::test
