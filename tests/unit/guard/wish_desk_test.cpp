// Which wishes are flown, and for how long.
#include "controller/guard/wish_desk.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {
namespace {

constexpr Time kMostAge = 5 * kTick;

TEST(WishDesk, BeforeTheFirstWishThePlannerIsStalled) {
  WishDesk desk(2, kMostAge);
  desk.judge(kTick, {});
  EXPECT_TRUE(desk.everybody().has(Symptom::kPlannerStalled));
  EXPECT_FALSE(desk.everybody().has(Symptom::kCommandRefused)) << "no wish is none that is refused";
  EXPECT_EQ(desk.kind(0), CommandKind::kNone);
}

TEST(WishDesk, AWishIsFlownUntilItsDeadlineAndNoTickLonger) {
  WishDesk desk(2, kMostAge);
  const WishOf wish(2);
  desk.judge(kTick, wish.columns(3 * kTick, 1));
  EXPECT_EQ(desk.kind(1), CommandKind::kVelocity);
  desk.judge(3 * kTick, wish.columns(3 * kTick, 1));
  EXPECT_TRUE(desk.everybody().empty()) << "at its deadline it is good";
  desk.judge(3 * kTick + Time(1), wish.columns(3 * kTick, 1));
  EXPECT_TRUE(desk.everybody().has(Symptom::kPlannerStalled));
  EXPECT_EQ(desk.kind(1), CommandKind::kNone);
  desk.judge(4 * kTick, wish.columns(9 * kTick, 2));
  EXPECT_TRUE(desk.everybody().empty()) << "a new wish ends the stall";
}

TEST(WishDesk, NobodyWishesForEver) {
  WishDesk desk(1, kMostAge);
  const WishOf wish(1);
  desk.judge(kTick, wish.columns(Time::max(), 1));
  desk.judge(kTick + kMostAge, wish.columns(Time::max(), 1));
  EXPECT_TRUE(desk.everybody().empty());
  desk.judge(kTick + kMostAge + Time(1), wish.columns(Time::max(), 1));
  EXPECT_TRUE(desk.everybody().has(Symptom::kPlannerStalled)) << "saying it again makes it no younger";
}

TEST(WishDesk, AnOldNumberIsRefusedAndTheWishBeforeStays) {
  WishDesk desk(1, kMostAge);
  desk.judge(kTick, WishOf(1, {1, 0, 0}).columns(9 * kTick, 7));
  desk.judge(2 * kTick, WishOf(1, {2, 0, 0}).columns(9 * kTick, 6));
  EXPECT_TRUE(desk.everybody().has(Symptom::kCommandRefused));
  EXPECT_EQ(desk.counters().refused, 1U);
  EXPECT_EQ(desk.kind(0), CommandKind::kVelocity);
  EXPECT_EQ(desk.vx()[0], 1.0F);
  desk.judge(3 * kTick, WishOf(1, {3, 0, 0}).columns(9 * kTick, 7));
  EXPECT_EQ(desk.vx()[0], 1.0F) << "one number, one wish";
  EXPECT_FALSE(desk.everybody().has(Symptom::kCommandRefused)) << "it is the same, told again";
}

TEST(WishDesk, WhatWasRefusedBeforeItIsToldOnce) {
  WishDesk desk(1, kMostAge);
  desk.refuse();
  desk.judge(kTick, WishOf(1).columns(9 * kTick, 1));
  EXPECT_TRUE(desk.everybody().has(Symptom::kCommandRefused));
  EXPECT_EQ(desk.kind(0), CommandKind::kVelocity) << "the one that came is good";
  desk.judge(2 * kTick, WishOf(1).columns(9 * kTick, 2));
  EXPECT_TRUE(desk.everybody().empty());
  EXPECT_EQ(desk.counters().refused, 1U);
}

TEST(WishDesk, MoreThanAHundredTimesWhatARobotCanDoIsAbsurd) {
  WishDesk desk(2, kMostAge, {1.0F, 3.0F});
  WishOf wish(2, {0, 100.0F, 0});
  desk.judge(kTick, wish.columns(9 * kTick, 1));
  EXPECT_TRUE(desk.symptoms()[0].empty()) << "too fast, but no more";
  wish.vy[0] = wish.vy[1] = 100.1F;
  desk.judge(2 * kTick, wish.columns(9 * kTick, 2));
  EXPECT_TRUE(desk.symptoms()[0].has(Symptom::kCommandAbsurd));
  EXPECT_TRUE(desk.symptoms()[1].empty()) << "this one can nearly do it";
  EXPECT_EQ(desk.kind(0), CommandKind::kVelocity) << "the governor's to shorten";
  EXPECT_EQ(desk.counters().absurd, 1U);
  wish.kind[0] = CommandKind::kHold;
  desk.judge(3 * kTick, wish.columns(9 * kTick, 3));
  EXPECT_TRUE(desk.symptoms()[0].empty()) << "nobody asks it to move";
}

TEST(WishDesk, ShortColumnsAreRefused) {
  WishDesk desk(3, kMostAge);
  desk.judge(kTick, WishOf(2).columns(9 * kTick, 1));
  EXPECT_TRUE(desk.everybody().has(Symptom::kCommandRefused));
  EXPECT_TRUE(desk.everybody().has(Symptom::kPlannerStalled));
}

TEST(WishDesk, WhatIsNoNumberIsNoWish) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    for (const CommandKind kind : {CommandKind::kVelocity, CommandKind::kHold}) {
      WishDesk desk(2, kMostAge);
      WishOf wish(2);
      wish.kind[1] = kind;  // Hal::write has made a hold of it on its way
      wish.vy[1] = bad;
      desk.judge(kTick, wish.columns(9 * kTick, 1));
      EXPECT_TRUE(desk.symptoms()[1].has(Symptom::kCommandNotFinite));
      EXPECT_TRUE(desk.symptoms()[0].empty());
      EXPECT_EQ(desk.kind(1), CommandKind::kNone);
      EXPECT_EQ(desk.kind(0), CommandKind::kVelocity);
      EXPECT_EQ(desk.counters().not_finite, 1U);
    }
  }
}

TEST(WishDesk, HugeNumbersAreNumbers) {
  WishDesk desk(1, kMostAge);
  desk.judge(kTick, WishOf(1, {3e38F, 0, 0}).columns(9 * kTick, 1));
  EXPECT_TRUE(desk.symptoms()[0].empty()) << "limits are the governor's";
}

TEST(WishDesk, AKindThatDoesNotExistIsRefused) {
  WishDesk desk(2, kMostAge);
  WishOf wish(2);
  wish.kind[0] = static_cast<CommandKind>(6);
  desk.judge(kTick, wish.columns(9 * kTick, 1));
  EXPECT_TRUE(desk.symptoms()[0].has(Symptom::kCommandRefused));
  EXPECT_EQ(desk.kind(0), CommandKind::kNone);
  wish.kind[0] = CommandKind::kStop;
  desk.judge(kTick, wish.columns(9 * kTick, 2));
  EXPECT_TRUE(desk.symptoms()[0].empty()) << "the last that exists";
}

TEST(WishDesk, AfterAResetNumbersBeginAnew) {
  WishDesk desk(1, kMostAge);
  desk.judge(kTick, WishOf(1).columns(9 * kTick, 1000));
  desk.reset();
  desk.judge(2 * kTick, WishOf(1).columns(9 * kTick, 1));
  EXPECT_TRUE(desk.everybody().empty());
}

}  // namespace
}  // namespace mayfly::test
