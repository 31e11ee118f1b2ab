// From one authority to another: what is kept of a robot's claim and of its reference.
#include <cmath>

#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

GovernorConfig with_life(std::size_t agents, float tube) {
  GovernorConfig config = default_config(agents);
  config.command_life = 40ms;
  config.groups[0].limits.tube = tube;
  return config;
}

TEST(Authority, WhoseMotorsStartUnseenKeepsItsPlace) {
  Rig rig(default_config(2));
  rig.place(1, {0.4F, 0, 0}, {0, 0, 0});
  rig.authority[1] = Authority::kAtRest;
  rig.tick();
  rig.authority[1] = Authority::kGoverned;
  rig.known[1] = 0;
  for (int n = 0; n < 100; ++n) {
    rig.tick({2, 0, 0});
    rig.fly(0);
  }
  EXPECT_LE(rig.x[0], 0.2F);
  EXPECT_GE(rig.x[0], 0.15F);
  EXPECT_EQ(rig.kind[1], CommandKind::kHold);
  EXPECT_FALSE(rig.governor.reference(1).known);
}

TEST(Authority, WhoGoesIsMindedNoLongerAndComesBackWhereItIsSeen) {
  Rig rig(default_config(2));
  rig.place(1, {0.4F, 0, 0}, {0, 0, 0});
  rig.tick();
  rig.authority[1] = Authority::kAbsent;
  for (int n = 0; n < 100; ++n) {
    rig.tick({2, 0, 0});
    rig.fly(0);
  }
  EXPECT_GE(rig.x[0], 1.0F);
  EXPECT_FALSE(rig.governor.reference(1).known);
  rig.authority[1] = Authority::kGoverned;
  rig.place(1, {5, 5, 0}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(1).body.x, 5.0, 1e-6);
}

TEST(Authority, WhoWasTakenAwayWhileItCoastedBeginsAnew) {
  Rig rig(with_life(1, 0.0F));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.tick({1, 0, 0});
  rig.now += 31ms;
  rig.tick({1, 0, 0});
  ASSERT_EQ(rig.kind[0], CommandKind::kHold);
  rig.authority[0] = Authority::kAbsent;
  rig.tick({1, 0, 0});
  rig.authority[0] = Authority::kGoverned;
  rig.place(0, {5, 0, 0}, {0, 0, 0});
  EXPECT_NEAR(rig.tick({1, 0, 0}).x, 0.04, 1e-6);
  EXPECT_NEAR(rig.governor.reference(0).body.x, 5.0, 1e-6);
}

TEST(Authority, WhoIsSilentFromTheStartHasNoClaim) {
  Rig rig(default_config(2));
  rig.known[1] = 0;
  rig.tick();
  rig.authority[1] = Authority::kSilent;
  EXPECT_NEAR(rig.tick({0.04F, 0, 0}).x, 0.04, 1e-6);
  EXPECT_EQ(rig.kind[1], CommandKind::kHold);
}

TEST(Authority, AnUngovernedRobotThatIsSilentIsOnlyToldToBrake) {
  GovernorConfig config = default_config(1);
  config.groups[0].enabled = false;
  Rig rig(config);
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.tick({1, 0, 0});
  rig.authority[0] = Authority::kSilent;
  EXPECT_NEAR(rig.tick({1, 0, 0}).x, 0.96, 1e-6);
}

// 40 ms, then 1 m/s at 4 m/s²: 0.29 s from the tick in which its command had run out, silent or not.
TEST(Authority, SilenceDoesNotMakeOneThatCoastsStart) {
  Rig rig(with_life(1, 0.0F));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.tick({1, 0, 0});
  rig.now += 31ms;
  rig.tick({1, 0, 0});
  for (int n = 0; n < 24; ++n) {
    rig.authority[0] = n > 5 && n < 15 ? Authority::kSilent : Authority::kGoverned;
    ASSERT_EQ(rig.tick({1, 0, 0}), glm::vec3(0.0F)) << n;
    ASSERT_EQ(rig.kind[0], CommandKind::kHold) << n;
  }
  EXPECT_NEAR(rig.tick({1, 0, 0}).x, 0.04, 1e-6);
}

// Three lags more, in which it comes to rest.
TEST(Authority, ALagIsWaitedForAsWell) {
  for (const float lag : {0.0F, 0.1F}) {
    GovernorConfig config = with_life(1, 0.0F);
    config.groups[0].limits.response_time = lag;
    Rig rig(config);
    rig.place(0, {0, 0, 0}, {1, 0, 0});
    rig.tick({1, 0, 0});
    rig.now += 31ms;
    rig.tick({1, 0, 0});
    int ticks = 0;
    for (; rig.kind[0] == CommandKind::kHold && ticks < 100; ++ticks) {
      rig.tick({1, 0, 0});
    }
    EXPECT_EQ(ticks, lag > 0.0F ? 55 : 25);
  }
}

TEST(Authority, OneThatCoastsElsewhereIsToldAndItsClaimStays) {
  for (const float side : {0.04F, 0.5F}) {
    Rig rig(with_life(2, 0.05F));
    rig.place(0, {0, 0, 0}, {1, 0, 0});
    rig.place(1, {0.1F, 0.35F, 0}, {0, 0, 0});
    rig.tick({1, 0, 0});
    rig.now += 31ms;
    rig.place(0, {0.04F, -side, 0}, {1, 0, 0});
    rig.tick({1, 0, 0});
    EXPECT_EQ(rig.kind[0], CommandKind::kHold);
    EXPECT_EQ(rig.symptoms[0].has(Symptom::kTrackingError), side > 0.05F);
    EXPECT_EQ(rig.governor.counters().nudges, 0U);
    EXPECT_FALSE(rig.symptoms[1].has(Symptom::kTooNear));
    for (int n = 0; n < 20; ++n) {
      rig.desire(1, {0, -2, 0});
      rig.tick({1, 0, 0});
      rig.fly(1);
    }
    EXPECT_GE(rig.y[1], 0.3F);
  }
}

// Both places, also where a tick is so late that nothing can be told.
TEST(Authority, OneThatWasMeasuredElsewhereIsAtBothPlacesInALateTick) {
  Rig rig(with_life(2, 0.05F));
  rig.place(0, {0, 0, 0}, {2, 0, 0});
  rig.place(1, {0.08F, 3.2F, 0}, {0, 0, 0});
  rig.tick({2, 0, 0});
  EXPECT_FALSE(rig.symptoms[1].has(Symptom::kTooNear));
  rig.place(0, {0.02F, 3, 0}, {0, 0, 0});
  rig.anew = {1, 0};
  rig.tick({2, 0, 0});
  rig.anew = {0, 0};
  rig.now += 20ms;
  rig.tick({std::nanf(""), 0, 0});
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTrackingError));
  EXPECT_TRUE(rig.symptoms[1].has(Symptom::kTooNear));
}

TEST(Authority, OneThatIsFirstSeenInALateTickFliesOnIfASingleTickBrakesIt) {
  for (const float speed : {0.03F, 1.0F}) {
    Rig rig(default_config(1));
    rig.known[0] = 0;
    rig.tick({0, 0, 0});
    rig.now += 490ms;
    rig.known[0] = 1;
    rig.place(0, {9.9F, 0, 0}, {speed, 0, 0});
    rig.tick({speed, 0, 0});
    EXPECT_EQ(rig.kind[0], speed < 0.04F ? CommandKind::kVelocity : CommandKind::kHold);
  }
}

Rig landing_at(float speed) {
  Rig rig(default_config(1));
  rig.place(0, {0, 0, 1}, {speed, 0, 0});
  rig.tick({speed, 0, 0});
  rig.fly(0);
  rig.authority[0] = Authority::kLanding;
  return rig;
}

TEST(Authority, WhoLandsComesToRestFirst) {
  Rig rig = landing_at(1.0F);
  for (int n = 0; n < 24; ++n) {
    rig.tick({1, 0, 0});
    rig.fly(0);
    ASSERT_EQ(rig.kind[0], CommandKind::kVelocity) << n;
  }
  rig.tick({1, 0, 0});
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  rig.tick({1, 0, 0});
  EXPECT_EQ(rig.kind[0], CommandKind::kLand);
}

TEST(Authority, WhoIsTakenUpAgainBeginsWhereItIsSeen) {
  Rig rig = landing_at(0.0F);
  rig.tick({0, 0, 0});
  ASSERT_EQ(rig.kind[0], CommandKind::kLand);
  rig.place(0, {0, 0, 0.3F}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.z, 1.0, 1e-6);
  rig.authority[0] = Authority::kGoverned;
  rig.tick({0, 0, 0});
  EXPECT_NEAR(rig.governor.reference(0).body.z, 0.3, 1e-6);
  EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
}

TEST(Authority, WhoIsHeardAgainOnlyToLandCoastsUntilItRests) {
  Rig rig = landing_at(1.0F);
  rig.authority[0] = Authority::kSilent;
  rig.tick({1, 0, 0});
  rig.authority[0] = Authority::kLanding;
  rig.place(0, {0.1F, 0, 1}, {0, 0, 0});
  for (int n = 0; n < 25; ++n) {  // 10 ms, then 1 m/s at 4 m/s²: 0.26 s from when it was silent
    rig.tick({1, 0, 0});
    ASSERT_EQ(rig.kind[0], CommandKind::kHold) << n;
  }
  rig.tick({1, 0, 0});
  EXPECT_EQ(rig.kind[0], CommandKind::kLand);
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.1, 1e-6);
}

TEST(Authority, WhoWasToldToLandIsNotToldOtherwiseBySomebodyBelow) {
  Rig rig(default_config(2));
  rig.place(0, {0, 0, 1}, {0, 0, 0});
  rig.place(1, {5, 0, 0}, {0, 0, 0});
  rig.authority = {Authority::kLanding, Authority::kForeign};
  rig.tick();
  ASSERT_EQ(rig.kind[0], CommandKind::kLand);
  rig.place(1, {0, 0, 0.4F}, {0, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.kind[0], CommandKind::kLand);
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTooNear));
}

TEST(Authority, WhoIsFirstSeenWhileItLandsIsWhereItIsSeen) {
  Rig rig(default_config(1));
  rig.authority[0] = Authority::kLanding;
  rig.place(0, {3, 0, 1}, {0, 0, 0});
  rig.tick({0, 0, 0});
  EXPECT_EQ(rig.kind[0], CommandKind::kLand);
  EXPECT_NEAR(rig.governor.reference(0).body.x, 3.0, 1e-6);
}

}  // namespace
}  // namespace mayfly::governor_test
