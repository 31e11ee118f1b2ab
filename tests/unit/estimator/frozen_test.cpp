// Fresh stamps and the same place, while the robot is told to move.
#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

// Told to move from the first tick on; the pose stays. Returns the tick of the alarm, 0 for none.
int frozen_tick(Rig& rig, Vec velocity, int ticks) {
  rig.tell(0, velocity);
  for (int i = 1; i <= ticks; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    if (rig.has(0, Symptom::kFrozenPose)) {
      return i;
    }
  }
  return 0;
}

TEST(FrozenPose, IsToldAtTheFifthEqualOne) {
  Rig rig(config_of(1));
  EXPECT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 20), 5);
}

TEST(FrozenPose, FourEqualOnesAreNone) {
  Rig rig(config_of(1));
  EXPECT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 4), 0);
  for (int i = 0; i < 50; ++i) {
    const int step = i / 4;
    rig.put(0, {1.001 + 0.001 * step, 2.0, 3.0});
    rig.tick();
    ASSERT_FALSE(rig.has(0, Symptom::kFrozenPose));
  }
}

TEST(FrozenPose, AsManyAsTheConfigurationSays) {
  EstimatorConfig config = config_of(1);
  config.frozen_samples = 9;
  Rig rig(config);
  EXPECT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 20), 9);
}

TEST(FrozenPose, WhoStandsStillIsNotFrozen) {
  Rig held(config_of(1));
  held.tell_hold(0);
  for (int i = 0; i < 500; ++i) {
    held.put(0, {1.0, 2.0, 3.0});
    held.tick();
    ASSERT_FALSE(held.has(0, Symptom::kFrozenPose));
    ASSERT_TRUE(held.known(0));
  }
  Rig told_zero(config_of(1));
  EXPECT_EQ(frozen_tick(told_zero, {0.0, 0.0, 0.0}, 500), 0);
}

TEST(FrozenPose, BelowAMillimetreOfToldWayItIsNotTold) {
  // At 0.01 m/s: 1 mm after 0.1 s.
  Rig rig(config_of(1));
  EXPECT_EQ(frozen_tick(rig, {0.01, 0.0, 0.0}, 10), 0);
  Rig longer(config_of(1));
  EXPECT_EQ(frozen_tick(longer, {0.01, 0.0, 0.0}, 20), 12);
}

TEST(FrozenPose, ToAndFroIsNoWay) {
  Rig rig(config_of(1));
  for (int i = 0; i < 200; ++i) {
    rig.tell(0, {i % 2 == 0 ? 0.05 : -0.05, 0.0, 0.0});
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    ASSERT_FALSE(rig.has(0, Symptom::kFrozenPose));
  }
}

TEST(FrozenPose, ARobotThatLagsIsGivenTheTime) {
  EstimatorConfig config = config_of(1);
  config.robots[0].response_time = 0.5F;
  config.sources[0].resolution = 0.005F;
  Rig rig(config);
  const int tick = frozen_tick(rig, {0.5, 0.0, 0.0}, 100);
  // v (t − τ (1 − e^(−t/τ))) is 1 mm and the cell's 8.7 mm at t = 0.145 s.
  EXPECT_GE(tick, 15);
  EXPECT_LE(tick, 17);
}

TEST(FrozenPose, WithinACellOfTheResolutionAPlaceMayStay) {
  EstimatorConfig config = config_of(1);
  config.sources[0].resolution = 0.01F;
  Rig rig(config);
  // At 0.1 m/s: 18.3 mm after 0.183 s.
  EXPECT_EQ(frozen_tick(rig, {0.1, 0.0, 0.0}, 18), 0);
  Rig longer(config);
  EXPECT_EQ(frozen_tick(longer, {0.1, 0.0, 0.0}, 40), 20);
}

TEST(FrozenPose, OneBitIsADifference) {
  Rig rig(config_of(1));
  rig.tell(0, {1.0, 0.0, 0.0});
  float x = 1.0F;
  for (int i = 0; i < 100; ++i) {
    x = std::nextafter(x, i % 2 == 0 ? 2.0F : 0.0F);
    rig.put(0, {static_cast<double>(x), 2.0, 3.0});
    rig.tick();
    ASSERT_FALSE(rig.has(0, Symptom::kFrozenPose));
  }
}

TEST(FrozenPose, IsNotTakenAndEndsUnknown) {
  Rig rig(config_of(1));
  ASSERT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 20), 5);
  EXPECT_EQ(rig.count(SampleFate::kFrozen), 3U);  // from the third on, before it is called frozen
  for (int i = 0; i < 2; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    EXPECT_TRUE(rig.known(0));
  }
  rig.put(0, {1.0, 2.0, 3.0});
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
  EXPECT_FALSE(rig.known(0));
}

TEST(FrozenPose, OneSampleThatIsEqualMayComeOfAnEarlyStop) {
  Rig rig(config_of(1));
  ASSERT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 1), 0);
  rig.tell_hold(0);
  for (int i = 0; i < 20; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    ASSERT_TRUE(rig.known(0));
  }
  EXPECT_EQ(rig.count(SampleFate::kFrozen), 0U);
}

TEST(FrozenPose, StaysWhileTheRobotIsHeldAndClearsWithTheFirstOther) {
  Rig rig(config_of(1));
  ASSERT_EQ(frozen_tick(rig, {1.0, 0.0, 0.0}, 20), 5);
  rig.tell_hold(0);
  for (int i = 0; i < 100; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    ASSERT_TRUE(rig.has(0, Symptom::kFrozenPose)) << "the reaction to an alarm does not end it";
  }
  rig.put(0, {1.1, 2.0, 3.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
  EXPECT_TRUE(rig.known(0));
}

TEST(FrozenPose, IsNotEndedByBeingToldToGoBack) {
  Rig rig(config_of(1));
  ASSERT_EQ(frozen_tick(rig, {0.5, 0.0, 0.0}, 20), 5);
  rig.tell(0, {-0.1, 0.0, 0.0});
  for (int i = 0; i < 60; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    ASSERT_TRUE(rig.has(0, Symptom::kFrozenPose)) << i;
  }
}

TEST(FrozenPose, ExpiredAndWrongCommandsMoveNobody) {
  Rig rig(config_of(1));
  rig.tell(0, {0.0, std::nan(""), 0.0});
  for (int i = 0; i < 50; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.tick();
    ASSERT_FALSE(rig.has(0, Symptom::kFrozenPose));
  }
  const std::vector<CommandKind> kind{CommandKind::kVelocity};
  const std::vector<float> one{1.0F}, none{0.0F}, empty;
  for (int i = 0; i < 50; ++i) {
    rig.put(0, {1.0, 2.0, 3.0});
    rig.estimator.update(rig.now);
    rig.estimator.sent(rig.now, {kind, one, none, none, rig.now, 1});  // expires at once
    rig.estimator.sent(rig.now, {kind, one, none, empty, rig.now + kPeriod, 1});
    rig.now += kPeriod;
    ASSERT_FALSE(rig.has(0, Symptom::kFrozenPose));
  }
}

}  // namespace
}  // namespace mayfly::estimator_test
