// Our own account of where a robot is: it moves as the robot does, is watched, and is moved when it must be.
#include "controller/governor/reference.hpp"

#include <cmath>
#include <limits>

#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(Reference, MovesAsFarAsTheRobotDoes) {
  Reference at_once(0);
  at_once.adopt({1, 0, 0}, {0, 0, 0}, {0.1, kNever, 0.0});
  at_once.advance({1, 0, 0}, {0.1, kNever, 0.0});
  EXPECT_DOUBLE_EQ(at_once.body().x, 1.1);
  Reference accelerating(0);
  accelerating.adopt({1, 0, 0}, {0, 0, 0}, {0.1, 20.0, 0.0});
  accelerating.advance({1, 0, 0}, {0.1, 20.0, 0.0});  // half of the tick at 20 m/s², then 1 m/s
  EXPECT_DOUBLE_EQ(accelerating.body().x, 1.0 + 0.025 + 0.05);
  accelerating.advance({4, 0, 0}, {0.1, 20.0, 0.0});  // more than it can: as if it could
  EXPECT_DOUBLE_EQ(accelerating.body().x, 1.075 + 0.25);
}

TEST(Reference, ABodyTrailsItsLeadAsALagDoes) {
  const ReferenceModel model{0.01, 20.0, 0.1};
  Reference reference(0);
  reference.adopt({0, 0, 0}, {0, 0, 0}, model);
  for (int tick = 0; tick < 30; ++tick) {
    reference.advance({1, 0, 0}, model);
  }
  EXPECT_NEAR(reference.lead().x, 0.3, 1e-12);
  EXPECT_NEAR(reference.body().x, 0.3 - 0.1 * (1.0 - std::exp(-3.0)), 1e-12);
}

TEST(Reference, WithALatencyThePlacesOfTheLastTicksCount) {
  const ReferenceModel model{0.1, kNever, 0.0};
  Reference reference(2);
  reference.adopt({0, 0, 0}, {0, 0, 0}, model);
  for (int tick = 0; tick < 3; ++tick) {
    reference.advance({1, 0, 0}, model);
  }
  EXPECT_NEAR(length3(reference.way_to({0.15, 0, 0})), 0.0, 1e-12);
  EXPECT_NEAR(reference.way_to({0.0, 0, 0}).x, -0.1, 1e-12);
  EXPECT_NEAR(reference.way_to({0.4, 0, 0}).x, 0.1, 1e-12);
  EXPECT_NEAR(reference.tail_reach(model), 0.2, 1e-12);
  reference.shift({0, 1, 0});
  EXPECT_NEAR(length3(reference.way_to({0.15, 1, 0})), 0.0, 1e-12);
}

GovernorConfig with_tube(std::size_t agents, float tube) {
  GovernorConfig config = default_config(agents);
  config.groups[0].limits.tube = tube;
  return config;
}

TEST(Tracking, BeyondTheTubeIsTold) {
  for (const float off : {0.049F, 0.051F}) {
    Rig rig(with_tube(1, 0.05F));
    rig.tick({0, 0, 0});
    rig.place(0, {off, 0, 0}, {0, 0, 0});
    rig.tick({0, 0, 0});
    EXPECT_EQ(rig.symptoms[0].has(Symptom::kTrackingError), off > 0.05F);
    for (int n = 0; n < 10; ++n) {  // the reference comes nearer, and it is forgotten that it did
      rig.tick({0, 0, 0});
    }
    EXPECT_FALSE(rig.symptoms[0].has(Symptom::kTrackingError));
  }
}

TEST(Tracking, BeyondHalfTheTubeTheReferenceIsMoved) {
  Rig rig(with_tube(1, 0.05F));
  rig.tick({0, 0, 0});
  rig.place(0, {0.024F, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_EQ(rig.governor.counters().nudges, 0U);
  rig.place(0, {0.03F, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_EQ(rig.governor.counters().nudges, 1U);
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.005, 1e-6);
  rig.place(0, {1.0F, 0, 0}, {0, 0, 0});  // no faster than it could have flown: 0.02 m a tick
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.025, 1e-6);
}

TEST(Tracking, AReferenceIsOnlyMovedToWhereItIsFree) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(1, {0.301F, 0, 0}, {0, 0, 0});
  rig.tick();
  rig.place(0, {0.04F, 0, 0}, {0, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.governor.counters().nudges, 0U);
  rig.place(0, {-0.04F, 0, 0}, {0, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.governor.counters().nudges, 1U);
}

TEST(Tracking, AsFarAsTheTubeReachesTheRobotItsReferenceFollows) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(1, {0.301F, 0, 0}, {0, 0, 0});
  rig.tick();
  rig.place(0, {0.2F, 0, 0}, {0, 0, 0});
  for (int n = 0; n < 50; ++n) {
    rig.tick({0, 0, 0});
    ASSERT_TRUE(n > 5 || rig.symptoms[0].has(Symptom::kTrackingError));
  }
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.15, 1e-6);
}

// A reference that follows a drift hides it: what it was moved by is remembered.
bool is_told_of_drift(float speed) {
  Rig rig(with_tube(1, 0.05F));
  for (int n = 0; n < 300; ++n) {
    rig.place(0, {speed * 0.01F * static_cast<float>(n), 0, 0}, {speed, 0, 0});
    if (n == 0) {
      rig.place(0, {0, 0, 0}, {0, 0, 0});
    }
    rig.tick({0, 0, 0});
    if (rig.symptoms[0].has(Symptom::kTrackingError)) {
      EXPECT_LT(static_cast<float>(n) * 0.01F, 0.7F);
      return true;
    }
  }
  return false;
}

TEST(Tracking, ADriftIsToldWhereTheReferenceFollowsIt) {
  EXPECT_TRUE(is_told_of_drift(0.13F));
  EXPECT_FALSE(is_told_of_drift(0.09F));
}

TEST(Tracking, WhatIsNotMeasuredMovesNoReference) {
  Rig rig(with_tube(1, 0.05F));
  rig.tick({0, 0, 0});
  rig.place(0, {0.2F, 0, 0}, {0, 0, 0});
  rig.measured = {0};
  for (int n = 0; n < 10; ++n) {
    rig.tick({0, 0, 0});
  }
  EXPECT_EQ(rig.governor.counters().nudges, 0U);
  EXPECT_TRUE(rig.symptoms[0].empty());
  rig.measured = {1};
  rig.tick({0, 0, 0});
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTrackingError));
}

// Carried off, or measured wrongly: it may be at either place.
TEST(Tracking, OneThatIsMeasuredElsewhereClaimsBothPlaces) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(1, {0.5F, 2, 0}, {0, 0, 0});
  rig.tick();
  rig.place(0, {1, 0, 0}, {0, 0, 0});
  rig.anew = {1, 0};
  rig.tick({0, 0, 0});
  rig.anew = {0, 0};
  rig.desire(1, {0, -1, 0});
  for (int n = 0; n < 400; ++n) {
    rig.fly(1);
    rig.tick({0, 0, 0});
    ASSERT_TRUE(rig.symptoms[0].has(Symptom::kTrackingError));
  }
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.0, 1e-9);
  EXPECT_GT(rig.governor.reference(1).body.y, 0.3) << "it stays off the way between the two";
  rig.place(0, {0.01F, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_FALSE(rig.symptoms[0].has(Symptom::kTrackingError));
}

// What its firmware does is not ours: the way down must be free, and stays so.
TEST(Landing, BeginsOnceItsColumnIsFreeAndKeepsItFree) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(0, {0, 0, 1}, {0, 0, 0});
  rig.place(1, {0.1F, 0, 0}, {0, 0, 0});
  rig.tick();
  rig.authority[0] = Authority::kLanding;
  for (int n = 0; n < 50; ++n) {
    rig.tick({0, 0, 0});
    ASSERT_EQ(rig.kind[0], CommandKind::kHold) << "somebody is below it";
  }
  rig.desire(1, {1, 0, 0});
  int ticks = 0;
  for (; rig.kind[0] != CommandKind::kLand && ticks < 400; ++ticks) {
    rig.fly(1);
    rig.tick({0, 0, 0});
  }
  EXPECT_EQ(rig.kind[0], CommandKind::kLand);
  EXPECT_GT(rig.governor.reference(1).body.x, 0.29);
  rig.desire(1, {-1, 0, 0});
  for (int n = 0; n < 200; ++n) {
    rig.place(0, {0, 0, 1.0F - 0.005F * static_cast<float>(n)}, {0, 0, -0.5F});
    rig.fly(1);
    rig.tick({0, 0, 0});
    ASSERT_EQ(rig.kind[0], CommandKind::kLand);
    ASSERT_TRUE(rig.symptoms[0].empty()) << "it does not go where its reference stayed, and need not";
    ASSERT_GT(rig.governor.reference(1).body.x, 0.29);
  }
}

TEST(Tracking, WithoutATubeTheReferenceGoesWhereTheRobotIs) {
  Rig rig(default_config(1));
  rig.tick({0, 0, 0});
  rig.place(0, {0.01F, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.01, 1e-5);
  rig.place(0, {5.0F, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_TRUE(rig.symptoms[0].empty());
}

TEST(Tracking, OutOfTheFenceIsTold) {
  for (const float x : {9.89F, 9.91F}) {
    Rig rig(default_config(1));
    rig.place(0, {x, 0, 0}, {0, 0, 0});
    rig.tick({0, 0, 0});
    EXPECT_EQ(rig.symptoms[0].has(Symptom::kOutOfFence), x > 9.9F);
  }
}

TEST(Tracking, ACommandThatIsNoNumberIsTold) {
  Rig rig(default_config(1));
  rig.tick({std::nanf(""), 0, 0});
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kCommandNotFinite));
  rig.tick({0, 0, 0});
  EXPECT_TRUE(rig.symptoms[0].empty());
}

TEST(Skipping, ATickThatIsMissedFliesOn) {
  Rig rig(default_config(1));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.tick({1, 0, 0});
  rig.known[0] = 0;
  rig.now += 20ms;
  rig.tick({1, 0, 0});  // 30 ms after the last
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.03, 1e-9);
  EXPECT_EQ(rig.governor.counters().skipped_ticks, 2U);
  rig.now -= 1s;  // a clock that goes backwards is one tick
  rig.tick({1, 0, 0});
  EXPECT_EQ(rig.governor.counters().skipped_ticks, 2U);
}

}  // namespace
}  // namespace mayfly::governor_test
