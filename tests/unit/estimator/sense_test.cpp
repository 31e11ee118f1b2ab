// Poses that are missing, old, of the future, or no numbers.
#include <limits>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(StalePose, IsToldAfterTheAgeLimitAndNotBefore) {
  Rig rig(config_of(2));
  rig.put(0, {1.0, 0.0, 1.0}, {0.5, 0.0, 0.0});
  rig.tick();
  for (int age = 1; age <= 5; ++age) {
    rig.lose(0);
    rig.tick();
    EXPECT_FALSE(rig.has(0, Symptom::kStalePose)) << age;
    EXPECT_TRUE(rig.known(0)) << age;
  }
  const Vec last = rig.place(0);
  rig.tick();  // 60 ms old, the first tick beyond 50 ms
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
  EXPECT_FALSE(rig.known(0));
  EXPECT_EQ(rig.place(0), last) << "what is not known does not move on";
}

TEST(StalePose, ClearsWithTheFirstGoodPose) {
  Rig rig(config_of(1));
  rig.put(0, {1.0, 0.0, 1.0});
  for (int i = 0; i < 20; ++i) {
    rig.tick();
  }
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
  rig.put(0, {1.1, 0.0, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
  EXPECT_TRUE(rig.known(0));
  EXPECT_FLOAT_EQ(rig.estimator.estimate().x[0], 1.1F);
}

TEST(StalePose, OfARobotThatWasNeverSeenCountsFromTheFirstUpdate) {
  Rig rig(config_of(1));
  for (int i = 0; i <= 5; ++i) {
    rig.tick();
    EXPECT_FALSE(rig.has(0, Symptom::kStalePose)) << i;
    EXPECT_FALSE(rig.known(0));
  }
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
  EXPECT_TRUE(std::isnan(rig.estimator.estimate().x[0]));
}

TEST(StalePose, TheSameStampIsNoNewPose) {
  Rig rig(config_of(1));
  const Time stamp = rig.now;
  for (int i = 0; i < 7; ++i) {
    rig.put_at(0, {1.0, 0.0, 1.0}, {}, stamp);
    rig.tick();
  }
  EXPECT_TRUE(rig.has(0, Symptom::kStalePose));
  EXPECT_EQ(rig.count(SampleFate::kTaken), 1U);
}

TEST(StalePose, OneThatArrivesOlderThanTheLimitIsNotTaken) {
  Rig rig(config_of(1));
  rig.put_at(0, {1.0, 0.0, 1.0}, {}, rig.now - 5 * kPeriod);
  rig.tick();
  EXPECT_TRUE(rig.known(0));
  rig.put_at(0, {1.0, 0.0, 1.0}, {}, rig.now - 5 * kPeriod - Time(1));
  rig.tick();
  EXPECT_FALSE(rig.known(0));
  EXPECT_EQ(rig.count(SampleFate::kTooOld), 1U);
}

TEST(FutureStamp, IsTakenUpToTheLimitAndRefusedBeyond) {
  Rig rig(config_of(1));
  rig.put_at(0, {1.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, rig.now + kPeriod);
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kTaken), 1U);
  EXPECT_NEAR(rig.place(0)[0], 0.99, 1e-6) << "predicted back to the tick";
  rig.put_at(0, {1.0, 0.0, 1.0}, {}, rig.now + kPeriod + Time(1));
  rig.tick();
  EXPECT_EQ(rig.count(SampleFate::kFuture), 1U);
}

TEST(FutureStamp, ASourceWithAWrongClockIsStaleAtTheAgeLimit) {
  Rig rig(config_of(1));
  rig.put(0, {1.0, 0.0, 1.0});
  rig.tick();
  for (int i = 1; i <= 6; ++i) {
    rig.put_at(0, {1.0, 0.0, 1.0}, {}, rig.now + std::chrono::hours(1));
    rig.tick();
    EXPECT_EQ(rig.has(0, Symptom::kStalePose), i > 5) << i;
  }
  rig.put(0, {1.0, 0.0, 1.0});
  rig.tick();
  EXPECT_FALSE(rig.has(0, Symptom::kStalePose));
}

class NotAPlace : public ::testing::TestWithParam<double> {};

TEST_P(NotAPlace, IsToldAtOnceDroppedAndForgottenWithTheNextGoodOne) {
  Rig rig(config_of(1));
  rig.put(0, {1.0, 0.0, 1.0}, {0.5, 0.0, 0.0});
  rig.tick();
  rig.put(0, {1.0, GetParam(), 1.0}, {0.5, 0.0, 0.0});
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kPoseNotFinite));
  EXPECT_EQ(rig.count(SampleFate::kNotFinite), 1U);
  EXPECT_TRUE(rig.known(0));
  EXPECT_NEAR(rig.place(0)[0], 1.005, 1e-6) << "coasts";
  rig.lose(0);
  rig.tick();
  EXPECT_TRUE(rig.has(0, Symptom::kPoseNotFinite)) << "nothing better was heard";
  rig.put(0, {1.01, 0.0, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
}
INSTANTIATE_TEST_SUITE_P(Values, NotAPlace, ::testing::Values(kNaN, kInfinity, -kInfinity, 1.01e6, -3e38));

TEST(NotANumber, CountsTowardsTheAge) {
  Rig rig(config_of(1));
  rig.put(0, {1.0, 0.0, 1.0});
  rig.tick();
  for (int i = 1; i <= 6; ++i) {
    rig.put(0, {kNaN, kNaN, kNaN});
    rig.tick();
    EXPECT_EQ(rig.known(0), i <= 5) << i;
  }
}

TEST(NotANumber, FarAwayIsStillAPlace) {
  Rig rig(config_of(1));
  rig.put(0, {0.99e6, -0.99e6, 0.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[0].empty());
  EXPECT_TRUE(rig.known(0));
}

TEST(NotANumber, AVelocityCountsOnlyWhereItIsTaken) {
  EstimatorConfig config = config_of(1);
  Rig takes(config);
  takes.put(0, {1.0, 0.0, 1.0}, {0.0, kNaN, 0.0});
  takes.tick();
  EXPECT_TRUE(takes.has(0, Symptom::kPoseNotFinite));
  EXPECT_FALSE(takes.known(0));
  config.sources[0].takes_velocity = false;
  Rig derives(config);
  derives.put(0, {1.0, 0.0, 1.0}, {0.0, kNaN, 0.0});
  derives.tick();
  EXPECT_TRUE(derives.known(0));
  EXPECT_TRUE(derives.estimator.estimate().symptoms[0].empty());
}

TEST(NotANumber, ANeighbourIsNotTouched) {
  Rig rig(config_of(2));
  rig.put(0, {kNaN, 0.0, 1.0});
  rig.put(1, {4.0, 0.0, 1.0});
  rig.tick();
  EXPECT_TRUE(rig.estimator.estimate().symptoms[1].empty());
  EXPECT_TRUE(rig.known(1));
}

TEST(Telemetry, IsHandedOnAsTheSourceLeftIt) {
  Rig rig(config_of(2));
  EXPECT_EQ(rig.estimator.telemetry()[1].heard, Time::min());
  rig.estimator.inbox().telemetry[1].heard = rig.now;
  rig.estimator.inbox().telemetry[1].battery = 0.5F;
  rig.tick();
  EXPECT_EQ(rig.estimator.telemetry()[1].battery, 0.5F);
  EXPECT_EQ(rig.estimator.telemetry()[0].heard, Time::min());
}

}  // namespace
}  // namespace mayfly::estimator_test
