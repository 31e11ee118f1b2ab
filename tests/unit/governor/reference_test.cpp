// Our own account of where a robot is: it moves as the robot does, is watched, and is moved when it must be.
#include "controller/governor/reference.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "bench/governor/true_robot.hpp"
#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

TEST(Reference, MovesAsFarAsTheRobotDoes) {
  Reference at_once(0);
  at_once.adopt({1, 0, 0}, {0, 0, 0}, {kNever, 0.0});
  at_once.advance({1, 0, 0}, 0.1, {kNever, 0.0});
  EXPECT_DOUBLE_EQ(at_once.body().x, 1.1);
  Reference accelerating(0);
  accelerating.adopt({1, 0, 0}, {0, 0, 0}, {20.0, 0.0});
  accelerating.advance({1, 0, 0}, 0.1, {20.0, 0.0});  // half of the tick at 20 m/s², then 1 m/s
  EXPECT_DOUBLE_EQ(accelerating.body().x, 1.0 + 0.025 + 0.05);
  accelerating.advance({4, 0, 0}, 0.1, {20.0, 0.0});  // more than it can: on the way to it
  EXPECT_DOUBLE_EQ(accelerating.body().x, 1.075 + 0.2);
  EXPECT_DOUBLE_EQ(accelerating.velocity().x, 3.0);
}

TEST(Reference, ABodyTrailsItsLeadAsALagDoes) {
  const ReferenceModel model{20.0, 0.1};
  Reference reference(0);
  reference.adopt({0, 0, 0}, {0, 0, 0}, model);
  for (int tick = 0; tick < 30; ++tick) {
    reference.advance({1, 0, 0}, 0.01, model);
  }
  EXPECT_NEAR(reference.lead().x, 0.3, 1e-12);
  EXPECT_NEAR(reference.body().x, 0.3 - 0.1 * (1.0 - std::exp(-3.0)), 1e-12);
}

TEST(Reference, WithALatencyThePlacesOfTheLastTicksCount) {
  const ReferenceModel model{kNever, 0.0};
  Reference reference(2);
  reference.adopt({0, 0, 0}, {0, 0, 0}, model);
  for (int tick = 0; tick < 3; ++tick) {
    reference.advance({1, 0, 0}, 0.1, model);
  }
  EXPECT_NEAR(length3(reference.way_to({0.15, 0, 0})), 0.0, 1e-12);
  EXPECT_NEAR(reference.way_to({0.0, 0, 0}).x, -0.1, 1e-12);
  EXPECT_NEAR(reference.way_to({0.4, 0, 0}).x, 0.1, 1e-12);
  EXPECT_NEAR(reference.tail_reach(model), 0.2, 1e-12);
  reference.shift({0, 1, 0});
  EXPECT_NEAR(length3(reference.way_to({0.15, 1, 0})), 0.0, 1e-12);
}

TEST(Reference, TheTailOfALagBeginsWhereItsBodyWas) {
  const ReferenceModel model{kNever, 0.1};
  Reference reference(2);
  reference.adopt({0, 0, 0}, {0, 0, 0}, model);
  std::array<glm::dvec3, 4> bodies{};
  for (glm::dvec3& body : bodies) {
    reference.advance({1, 0, 0}, 0.1, model);
    body = reference.body();
  }
  Hull tail;
  reference.add_tail(tail, model);
  ASSERT_EQ(tail.points().size(), 3U);
  EXPECT_EQ(tail.points()[0], bodies[1]);
  EXPECT_NEAR(tail.points()[1].x, 0.2, 1e-12);
  EXPECT_NEAR(tail.points()[2].x, 0.3, 1e-12);
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

TEST(Tracking, WithinTheTubeTooItIsMovedNoFasterThanItFlies) {
  for (const float tube : {0.0F, 0.2F}) {
    Rig rig(with_tube(1, tube));
    rig.tick({0, 0, 0});
    rig.place(0, {0.15F, 0, 0}, {0, 0, 0});
    rig.tick({0, 0, 0});
    EXPECT_NEAR(rig.governor.reference(0).body.x, 0.02, 1e-6);
  }
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

TEST(Tracking, WhoIsBetweenTheTwoPlacesComesToNeither) {
  for (const float towards : {-1.0F, 1.0F}) {
    Rig rig(with_tube(2, 0.05F));
    rig.place(1, {0.6F, 0.02F, 0}, {0, 0, 0});
    rig.tick();
    rig.place(0, {1.2F, 0, 0}, {0, 0, 0});
    rig.anew = {1, 0};
    rig.tick({0, 0, 0});
    rig.anew = {0, 0};
    rig.desire(1, {towards, 0, 0});
    for (int n = 0; n < 400; ++n) {
      rig.fly(1);
      rig.tick({0, 0, 0});
    }
    EXPECT_GT(rig.governor.reference(1).body.x, 0.299) << "0.3 m apart";
    EXPECT_LT(rig.governor.reference(1).body.x, 0.901);
    rig.desire(1, {0, 1, 0});
    for (int n = 0; n < 100; ++n) {
      rig.fly(1);
      rig.tick({0, 0, 0});
    }
    EXPECT_GT(rig.governor.reference(1).body.y, 0.3) << "it may leave";
  }
}

TEST(Tracking, OneThatIsMeasuredElsewhereClaimsBothPlacesWhileItFlies) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(1, {0, 2.2F, 0}, {0, 0, 0});
  rig.tick();
  rig.place(0, {0, 2, 0}, {0, 0, 0});
  rig.anew = {1, 0};
  for (int n = 0; n < 4; ++n) {
    rig.tick({0, -1, 0});
    EXPECT_LT(rig.command(0).y, 0.0F);
    EXPECT_TRUE(rig.symptoms[1].has(Symptom::kTooNear)) << n;
    rig.anew = {0, 0};
  }
}

// 5 m/s for the 10 ms in which a robot at rest can do nothing.
TEST(Tracking, OneThatDoesNotGoWhereItIsToldIsLikeOneThatIsNotOurs) {
  for (const float speed : {0.0F, 5.0F}) {
    Rig rig(with_tube(2, 0.05F));
    rig.place(1, {0, 0.95F + 0.33F, 0}, {0, 0, 0});
    rig.tick();
    rig.place(0, {0, 1, 0}, {0, speed, 0});
    rig.anew = {1, 0};
    rig.tick({0, 0, 0});
    EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTrackingError));
    EXPECT_EQ(rig.symptoms[1].has(Symptom::kTooNear), speed > 0.0F);
  }
}

TEST(Tracking, AfterARefusedCallAReferenceIsTakenAnew) {
  Rig rig(with_tube(1, 0.05F));
  rig.tick({0, 0, 0});
  rig.known.clear();
  rig.tick({0, 0, 0});
  EXPECT_FALSE(rig.governor.reference(0).known);
  rig.known = {1};
  rig.place(0, {1, 0, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.x, 1.0, 1e-6);
  EXPECT_TRUE(rig.symptoms[0].empty());
}

// What its firmware does is not ours: the way down must be free, and stays so.
TEST(Landing, WhoIsInItsColumnDoesNotRiseToIt) {
  Rig rig(with_tube(2, 0.05F));
  rig.place(0, {0, 0, 1}, {0, 0, 0});
  rig.place(1, {0.2F, 0, 0.3F}, {0, 0, 0});
  rig.tick();
  rig.authority[0] = Authority::kLanding;
  rig.desire(1, {0.02F, 0, 1});
  for (int n = 0; n < 400; ++n) {
    rig.fly(1);
    rig.tick({0, 0, 0});
    ASSERT_EQ(rig.kind[0], CommandKind::kHold);
  }
  EXPECT_GT(glm::distance(rig.governor.reference(1).body, glm::dvec3(0, 0, 1)), 0.299);
}

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

GovernorConfig with_life(std::size_t agents, Time life) {
  GovernorConfig config = default_config(agents);
  config.command_life = life;
  return config;
}

TEST(Late, ARobotFliesOnUntilTheNextTickComes) {
  Rig rig(with_life(1, 40ms));
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

TEST(Late, AClockThatGoesBackwardsIsOneTick) {
  Rig rig(with_life(1, 40ms));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.tick({1, 0, 0});
  rig.measured = {0};
  rig.now -= 1s;
  rig.tick({1, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.01, 1e-9);
}

TEST(Late, ATickThatComesEarlyChangesLess) {
  Rig rig(default_config(1));
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.tick({2, 0, 0}).x, 0.04, 1e-6);
  rig.now -= 5ms;
  EXPECT_NEAR(rig.tick({2, 0, 0}).x, 0.06, 1e-6) << "5 ms after the last";
  EXPECT_NEAR(rig.governor.reference(0).velocity.x, 0.02, 1e-6) << "on the way to 0.04 m/s";
  rig.now -= 5ms;
  EXPECT_NEAR(rig.tick({std::nanf(""), 0, 0}).x, 0.04, 1e-6) << "and brakes less";
}

// A robot obeys until the deadline, then it brakes by itself: nobody knows how, but where.
TEST(Late, WhoseCommandRanOutHoldsUntilItMustBeAtRest) {
  for (const Time gap : {40ms, 41ms}) {
    Rig rig(with_life(1, 40ms));
    rig.place(0, {0, 0, 0}, {1, 0, 0});
    rig.tick({1, 0, 0});
    rig.now += gap - 10ms;
    rig.place(0, {0.04F, 0, 0}, {1, 0, 0});
    rig.tick({1, 0, 0});
    if (gap == 40ms) {
      EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
      continue;
    }
    EXPECT_EQ(rig.kind[0], CommandKind::kHold);
    EXPECT_TRUE(rig.symptoms[0].empty());
    rig.place(0, {0.15F, 0, 0}, {0, 0, 0});
    for (int i = 0; i < 24; ++i) {  // 40 ms, then 1 m/s at 4 m/s²: 0.29 s
      EXPECT_EQ(rig.tick({1, 0, 0}), glm::vec3(0.0F)) << i;
      EXPECT_EQ(rig.count(GovernorReason::kUnknown), static_cast<std::uint64_t>(i + 2));
    }
    EXPECT_NEAR(rig.tick({1, 0, 0}).x, 0.04, 1e-6);
    EXPECT_NEAR(rig.governor.reference(0).body.x, 0.15, 1e-6);
  }
}

// Whatever it does after the deadline, and however late ticks are until then: 0.04 m as told, as much again
// if the tick came that late and nothing was heard any more, 0.125 m to rest.
TEST(Late, RoomIsKeptForAllThatARobotDoesUnheard) {
  Rig rig(with_life(2, 40ms));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.place(1, {0.8F, 0, 0}, {0, 0, 0});
  rig.desire(0, {1, 0, 0});
  rig.tick();
  rig.now += 31ms;
  for (int i = 0; i < 200; ++i) {
    rig.desire(1, {-2, 0, 0});
    rig.known[0] = 0;
    rig.tick({1, 0, 0});
    rig.fly(1);
  }
  EXPECT_GE(rig.x[1], 0.04 + 0.125 + 0.2);
  EXPECT_LE(rig.x[1], 0.08 + 0.125 + 0.2 + 0.05);
}

// Ticks that come as they like, and commands that run out between: braking must always lie in what was
// reserved before.
TEST(Late, UnevenTicksBreakNothing) {
  constexpr double kLife = 0.025;
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> micros(500, 25000);
  std::uniform_real_distribution<float> wish(-1.0F, 1.0F);
  GovernorConfig config = with_life(2, 25ms);
  config.groups[0].limits.tube = 0.005F;
  Rig rig(config);
  rig.place(1, {0.5F, 0, 0}, {0, 0, 0});
  rig.tick();
  std::array<bench::TrueRobot, 2> robots;
  robots[1].place.x = 0.5;
  double least = 1.0;
  for (int i = 0; i < 20000; ++i) {
    const double time = 1e-6 * micros(random) * (random() % 50 == 0 ? 10.0 : 1.0);
    for (std::size_t r = 0; r < 2; ++r) {
      robots[r] = robots[r].after(glm::dvec3(rig.command(r)), std::min(time, kLife));
      robots[r] = robots[r].after(glm::dvec3(0.0), std::max(time - kLife, 0.0));
      rig.place(r, glm::vec3(robots[r].place), glm::vec3(robots[r].velocity));
      const float ahead = i % 400 < 200 ? 3.0F : -1.0F;
      rig.desire(r, {r == 0 ? ahead : -ahead, wish(random), wish(random)});
    }
    least = std::min(least, glm::distance(robots[0].place, robots[1].place));
    ASSERT_GE(least, 0.2) << i;
    rig.now += from_seconds(time);
    rig.tick();
    ASSERT_FALSE(rig.symptoms[0].has(Symptom::kTrackingError)) << i;
    ASSERT_FALSE(rig.symptoms[0].has(Symptom::kTooNear)) << i;
  }
  EXPECT_LE(least, 0.22);
  EXPECT_GE(rig.count(GovernorReason::kUnknown), 1000U);
}

}  // namespace
}  // namespace mayfly::governor_test
