#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/unit/link/link_pair.hpp"

namespace mayfly::link::test {
namespace {

constexpr Time kNow{1'000'000'000};
constexpr Time kLater = kNow + Time(10'000'000);

TEST(Wish, NothingIsWishedBeforeTheFirst) {
  Pair link(3);
  const CommandColumns wish = link.guard.wish(kNow);
  ASSERT_EQ(wish.kind.size(), 3U);
  EXPECT_EQ(wish.kind[0], CommandKind::kNone);
  EXPECT_LT(wish.deadline, Time(0));
  EXPECT_EQ(wish.sequence, 0U);
}

TEST(Wish, ArrivesAsItWasSent) {
  Pair link(3);
  link.planner.wish().kind[1] = static_cast<std::uint8_t>(CommandKind::kLand);
  link.planner.wish().vz[2] = -0.25F;
  link.planner.send_wish(kNow, kLater);
  const CommandColumns wish = link.guard.wish(kNow);
  EXPECT_EQ(wish.kind[1], CommandKind::kLand);
  EXPECT_EQ(wish.vz[2], -0.25F);
  EXPECT_EQ(wish.deadline, kLater);
  EXPECT_EQ(wish.sequence, 1U);
  EXPECT_EQ(link.guard.issued(), kNow);
}

TEST(Wish, ReadsBackAsItWasSent) {
  Pair link(3);
  EXPECT_FALSE(link.planner.sent()) << "nothing yet";
  link.wish_velocity(0.5F, kNow, kLater);
  const auto sent = link.planner.sent();
  ASSERT_TRUE(sent);
  EXPECT_EQ(sent->vx[2], 0.5F);
  EXPECT_EQ(sent->kind[0], static_cast<std::uint8_t>(CommandKind::kVelocity));
  EXPECT_FALSE(link.planner.sent()) << "it was looked at";
  link.planner.wish().head->owner ^= 1U;
  link.wish_velocity(0.5F, kNow, kLater);
  EXPECT_FALSE(link.planner.sent()) << "somebody else's";
}

TEST(Wish, StaysTheSameWithItsOldDeadlineUntilTheNext) {
  Pair link(1);
  link.wish_velocity(1.0F, kNow, kLater);
  static_cast<void>(link.guard.wish(kNow));
  const CommandColumns wish = link.guard.wish(kNow + Time(3'000'000'000));
  EXPECT_EQ(wish.deadline, kLater);
  EXPECT_EQ(wish.sequence, 1U);
  link.wish_velocity(2.0F, kNow, kLater);
  EXPECT_EQ(link.guard.wish(kNow).vx[0], 2.0F);
  EXPECT_EQ(link.guard.taken(), 2U);
}

// A deadline is at most kMostAge from when it was seen: one tick's worth more is cut, the limit itself is
// not.
TEST(Wish, ADeadlineInTheFarFutureIsCut) {
  Pair link(1);
  link.wish_velocity(1.0F, kNow, kNow + Pair::kMostAge);
  EXPECT_EQ(link.guard.wish(kNow).deadline, kNow + Pair::kMostAge);
  link.wish_velocity(1.0F, kNow, kNow + Pair::kMostAge + Time(1));
  EXPECT_EQ(link.guard.wish(kNow).deadline, kNow + Pair::kMostAge);
  link.wish_velocity(1.0F, kNow, Time::max());
  EXPECT_EQ(link.guard.wish(kNow).deadline, kNow + Pair::kMostAge);
  link.wish_velocity(1.0F, Time::max(), Time::min());
  EXPECT_EQ(link.guard.wish(kNow).deadline, Time(-1));
  EXPECT_LE(link.guard.issued(), kNow);
}

TEST(Wish, IsVoidOnceThePlannerIsGone) {
  Pair link(2);
  link.wish_velocity(1.0F, kNow, kLater);
  static_cast<void>(link.guard.wish(kNow));
  link.guard.planner_gone();
  link.wish_velocity(1.0F, kNow, kLater);  // from whoever still can write there
  const CommandColumns wish = link.guard.wish(kNow);
  EXPECT_EQ(wish.kind[0], CommandKind::kNone);
  EXPECT_LT(wish.deadline, Time(0));
  EXPECT_EQ(link.guard.taken(), 1U);
  EXPECT_EQ(wish.sequence, 2U) << "whoever took the last by its number takes this one, too";
}

TEST(Wish, OfTheGuardsOwnIsToHoldAndTakesThePlannersPlace) {
  Pair link(2);
  link.wish_velocity(1.0F, kNow, kLater);
  static_cast<void>(link.guard.wish(kNow));
  const CommandColumns hold = link.guard.hold(kLater);
  EXPECT_EQ(hold.kind[1], CommandKind::kHold);
  EXPECT_EQ(hold.vx[1], 0.0F);
  EXPECT_EQ(hold.deadline, kLater + Pair::kMostAge);
  EXPECT_EQ(hold.sequence, 2U);
  link.wish_velocity(1.0F, kLater, kLater);
  EXPECT_EQ(link.guard.wish(kLater).kind[1], CommandKind::kHold);
  EXPECT_EQ(link.guard.hold(kLater).sequence, 3U);
}

TEST(Wish, AKindThatThereIsNotIsNone) {
  Pair link(2);
  link.planner.wish().kind[0] = static_cast<std::uint8_t>(CommandKind::kStop);
  link.planner.wish().kind[1] = static_cast<std::uint8_t>(CommandKind::kStop) + 1;
  link.planner.send_wish(kNow, kLater);
  const CommandColumns wish = link.guard.wish(kNow);
  EXPECT_EQ(wish.kind[0], CommandKind::kStop);
  EXPECT_EQ(wish.kind[1], CommandKind::kNone);
  EXPECT_EQ(link.guard.refused(), 1U);
}

TEST(Wish, WhatIsNotFiniteIsLeftToTheGuard) {
  Pair link(1);
  link.wish_velocity(NAN, kNow, kLater);
  EXPECT_TRUE(std::isnan(link.guard.wish(kNow).vx[0]));
}

TEST(Requests, AreLevels) {
  Pair link(3);
  EXPECT_EQ(link.guard.stop(), StopLevel::kNone);
  link.planner.request_stop(StopLevel::kHold);
  link.planner.request_stop(StopLevel::kEmergencyStop);
  for (int tick = 0; tick < 3; ++tick) {
    static_cast<void>(link.guard.wish(kNow));
    EXPECT_EQ(link.guard.stop(), StopLevel::kEmergencyStop);
  }
  link.guard.planner_gone();
  static_cast<void>(link.guard.wish(kNow));
  EXPECT_EQ(link.guard.stop(), StopLevel::kEmergencyStop);
}

TEST(Requests, AcknowledgementsAreCounted) {
  Pair link(1);
  link.planner.acknowledge();
  link.planner.acknowledge();
  static_cast<void>(link.guard.wish(kNow));
  EXPECT_EQ(link.guard.acknowledged(), 2U);
}

TEST(View, ArrivesAsItWasShown) {
  Pair link(2);
  EXPECT_FALSE(link.planner.collect());
  const Word beat = link.planner.guard_beat();
  link.guard.view().x[1] = 4.0F;
  link.guard.view().sent_vz[1] = -1.0F;
  link.guard.view().airborne[0] = 1;
  link.guard.view().head->tick = 17;
  link.guard.show();
  EXPECT_NE(link.planner.guard_beat(), beat);
  ASSERT_TRUE(link.planner.collect());
  EXPECT_EQ(link.planner.view().x[1], 4.0F);
  EXPECT_EQ(link.planner.view().sent_vz[1], -1.0F);
  EXPECT_EQ(link.planner.view().airborne[0], 1);
  EXPECT_EQ(link.planner.view().head->tick, 17U);
  EXPECT_FALSE(link.planner.collect());
}

TEST(View, EventsComeUp) {
  Pair link(2);
  Event event{
      .time_ns = kNow.count(), .robot = 1, .fault = static_cast<std::uint32_t>(HalFault::kRobotSilent)};
  event.cause.fill('x');  // no end: one is put there
  link.guard.tell(event);
  const auto told = link.planner.next_event();
  ASSERT_TRUE(told);
  EXPECT_EQ(told->robot, 1U);
  EXPECT_EQ(std::strlen(told->cause.data()), told->cause.size() - 1);
  EXPECT_FALSE(link.planner.next_event());
}

TEST(Phases, CrossBothWays) {
  Pair link(1);
  EXPECT_EQ(link.planner.phase(), Phase::kStarting);
  link.guard.set_phase(Phase::kReady);
  EXPECT_EQ(link.planner.phase(), Phase::kReady);
  EXPECT_EQ(link.guard.want(), Want::kWait);
  link.planner.want(Want::kFly);
  EXPECT_EQ(link.guard.want(), Want::kFly);
  const Word beat = link.guard.planner_beat();
  link.planner.beat();
  EXPECT_NE(link.guard.planner_beat(), beat);
}

}  // namespace
}  // namespace mayfly::link::test
