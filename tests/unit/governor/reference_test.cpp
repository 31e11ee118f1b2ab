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
    rig.tick({0, 0, 0});  // the reference has come nearer by now
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
  rig.place(0, {0.2F, 0, 0}, {0, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.governor.counters().nudges, 0U);
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTrackingError));
  rig.place(0, {-0.2F, 0, 0}, {0, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.governor.counters().nudges, 1U);
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
