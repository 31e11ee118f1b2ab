// Poses where the robot cannot have got.
#include <random>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

// A robot that stands at the origin, measured for a while.
Rig standing(float noise, std::size_t robots = 1) {
  Rig rig(config_of(robots, noise));
  for (int i = 0; i < 30; ++i) {
    for (std::size_t r = 0; r < robots; ++r) {
      rig.put(r, {5.0 * static_cast<double>(r), 0.0, 1.0});
    }
    rig.tick();
  }
  return rig;
}

// v_max·Δt, and 3σ in every coordinate, of the measurement and of what it is held against.
double threshold(const Rig& rig, double noise, double seconds = 0.01) {
  const double sigma = rig.estimator.uncertainty(0).position;
  return 3.0 * seconds + 3.0 * std::sqrt(3.0) * std::sqrt(sigma * sigma + noise * noise);
}

class Threshold : public ::testing::TestWithParam<float> {};

TEST_P(Threshold, IsWhereItIsSaidToBe) {
  const double noise = static_cast<double>(GetParam());
  for (const double share : {0.99, 1.01}) {
    Rig rig = standing(GetParam());
    rig.put(0, {0.0, share * threshold(rig, noise), 1.0});
    rig.tick();
    EXPECT_EQ(rig.has(0, Symptom::kPoseJump), share > 1.0);
    EXPECT_EQ(rig.count(SampleFate::kJumped), share > 1.0 ? 1U : 0U);
    EXPECT_TRUE(rig.known(0));
  }
}
INSTANTIATE_TEST_SUITE_P(Noises, Threshold, ::testing::Values(0.0F, 0.002F, 0.05F));

TEST(Jump, IsRejectedAndOneGoodPoseClearsIt) {
  Rig rig = standing(0.0F);
  rig.put(0, {1.0, 0.0, 1.0});
  rig.tick();
  EXPECT_EQ(rig.place(0), (Vec{0.0, 0.0, 1.0}));
  EXPECT_EQ(rig.estimator.estimate().fresh[0], 0);
  rig.lose(0);
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kPoseJump)) << "nothing better was heard";
  rig.put(0, {0.01, 0.0, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
}

TEST(Jump, AFullTurnAtTopSpeedIsNone) {
  EstimatorConfig config = config_of(1);
  config.robots[0].acceleration = 1e4F;
  Rig rig(config);
  double x = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double v = i % 7 < 3 ? 3.0 : -3.0;
    x += 0.01 * v;
    rig.put(0, {x, 0.0, 1.0}, {v, 0.0, 0.0});
    rig.tick();
    ASSERT_FALSE(rig.has(0, Symptom::kPoseJump)) << i;
  }
}

TEST(Jump, AfterALongerGapMoreWayIsBelieved) {
  for (const double way : {0.118, 0.122}) {
    Rig rig = standing(0.0F);
    rig.lose(0);
    rig.tick(), rig.tick(), rig.tick();
    rig.put(0, {way, 0.0, 1.0});
    rig.tick();
    EXPECT_EQ(rig.has(0, Symptom::kPoseJump), way > 0.12);
  }
}

TEST(Jump, OfARobotWithoutASpeedLimitIsNotTold) {
  EstimatorConfig config = config_of(1);
  config.robots[0].speed = std::numeric_limits<float>::infinity();
  Rig rig(config);
  for (int i = 0; i < 10; ++i) {
    rig.put(0, {100.0 * i, 0.0, 1.0});
    rig.tick();
    EXPECT_FALSE(rig.has(0, Symptom::kPoseJump));
    EXPECT_EQ(rig.place(0)[0], 100.0 * i);
  }
}

// A simulated swarm that nobody governs: no gate, but numbers and ages.
TEST(WithoutGates, WhatIsANumberIsTaken) {
  EstimatorConfig config = config_of(2);
  config.gates = false;
  Rig rig(config);
  rig.tell(1, {1.0, 0.0, 0.0});
  for (int i = 0; i < 50; ++i) {
    rig.put(0, {100.0 * i, 0.0, 1.0}, {2.0, 0.0, 0.0});
    rig.put(1, {1.0, 1.0, 1.0});
    rig.tick();
    EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
    EXPECT_TRUE(rig.estimator.estimate().symptoms[1].empty());
    EXPECT_EQ(rig.place(0)[0], 100.0 * i);
  }
  rig.put(0, {std::nan(""), 0.0, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kPoseNotFinite));
  for (int i = 0; i < 6; ++i) {
    rig.tick();
  }
  EXPECT_TRUE(rig.has(1, Symptom::kStalePose));
}

TEST(ThreeJumps, AreToldBeforeTheFourthIsBelieved) {
  Rig rig = standing(0.0F);
  for (int i = 1; i <= 3; ++i) {
    rig.put(0, {1.0, 0.01 * i, 1.0});
    rig.tick();
    EXPECT_TRUE(rig.has(0, Symptom::kPoseJump)) << i;
    EXPECT_EQ(rig.place(0)[0], 0.0) << i;
  }
  rig.put(0, {1.0, 0.04, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
  EXPECT_EQ(rig.place(0), (Vec{1.0, static_cast<double>(0.04F), 1.0}));
  EXPECT_EQ(rig.estimator.counters().started_anew, 1U);
  EXPECT_EQ(rig.estimator.estimate().anew[0], 1) << "whoever relies on the place is told";
  rig.put(0, {1.0, 0.05, 1.0});
  rig.tick();
  EXPECT_EQ(rig.estimator.estimate().anew[0], 0);
}

TEST(ThreeJumps, TheTrackBeginsWithNoMoreThanOneSample) {
  Rig rig = standing(0.01F);
  for (int i = 0; i < 4; ++i) {
    rig.put(0, {1.0, 0.0, 1.0});
    rig.tick();
  }
  EXPECT_EQ(rig.estimator.counters().started_anew, 1U);
  EXPECT_NEAR(rig.estimator.uncertainty(0).position, 0.01, 1e-8);
  EXPECT_NEAR(rig.estimator.uncertainty(0).velocity, 3.0, 1e-8);
}

TEST(ThreeJumps, OfSeveralSourcesInOneTickAreNotAddedUp) {
  EstimatorConfig config = config_of(1);
  config.sources.resize(4);
  Rig rig(config);
  for (std::size_t s = 0; s < 4; ++s) {
    rig.put_at(0, {0.0, 0.0, 1.0}, {}, rig.now - Time(static_cast<int>(s)), s);
  }
  rig.tick();
  for (int tick = 1; tick <= 3; ++tick) {
    for (std::size_t s = 0; s < 4; ++s) {
      rig.put_at(0, {1.0, 0.0, 1.0}, {}, rig.now - Time(static_cast<int>(s)), s);
    }
    rig.tick();
    EXPECT_TRUE(rig.has(0, Symptom::kPoseJump));
    EXPECT_EQ(rig.place(0)[0], 0.0);
  }
}

TEST(ThreeJumps, ThatDoNotAgreeAreNeverBelieved) {
  Rig rig = standing(0.0F);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> anywhere(-40.0, 40.0);
  for (int i = 0; i < 2000; ++i) {
    rig.put(0, {anywhere(random), anywhere(random), anywhere(random)});
    rig.tick();
    ASSERT_TRUE(rig.has(0, Symptom::kPoseJump)) << i;
    ASSERT_EQ(rig.known(0), i < 5) << i;
  }
  EXPECT_EQ(rig.estimator.counters().started_anew, 0U);
}

TEST(ThreeJumps, DoNotGoAwayBecauseTheyLast) {
  // A place that v_max·Δt would reach in the end is told and believed as any other.
  Rig rig = standing(0.0F);
  int told = 0;
  for (int i = 0; i < 10; ++i) {
    rig.put(0, {0.06, 0.0, 1.0});
    rig.tick();
    told += rig.has(0, Symptom::kPoseJump) ? 1 : 0;
  }
  EXPECT_EQ(told, 3);
  EXPECT_EQ(rig.estimator.counters().started_anew, 1U);
}

TEST(ThreeJumps, OntoAnotherRobotAreNotBelieved) {
  Rig rig = standing(0.0F, 2);
  for (int i = 0; i < 10; ++i) {
    rig.put(0, {5.0, 0.02, 1.0});
    rig.put(1, {5.0, 0.0, 1.0});
    rig.tick();
    EXPECT_TRUE(rig.has(0, Symptom::kPoseJump)) << i;
  }
  EXPECT_FALSE(rig.known(0));
  EXPECT_TRUE(rig.known(1));
  for (int i = 0; i < 4; ++i) {
    rig.put(0, {4.0, 0.0, 1.0});
    rig.put(1, {5.0, 0.0, 1.0});
    rig.tick();
  }
  EXPECT_TRUE(rig.known(0)) << "believed where nobody else is";
}

}  // namespace
}  // namespace mayfly::estimator_test
