// Two robots: when one stands in another's way, and what those may do that nobody governs.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

// Robot 0 flies at 1 m/s along x towards robot 1, which stands `gap` m from where the first would rest if it
// flew on for a tick.
struct Meeting {
  explicit Meeting(float gap, GovernorConfig config = default_config(2)) : rig(config) {
    rig.place(0, {0, 0, 0}, {1, 0, 0});
    const auto rest = static_cast<float>(0.01 + stopping_distance(1.0, {4.0, 0.01, 0.0}));
    rig.place(1, {rest + 0.2F + gap, 0, 0}, {0, 0, 0});
    rig.desire(0, {1, 0, 0});
  }
  Rig rig;
};

TEST(GovernorPairs, ANeighbourFiresWhereTheStopWouldNotFit) {
  Meeting far(1e-3F);
  far.rig.tick();
  EXPECT_EQ(far.rig.command(0), glm::vec3(1, 0, 0));
  EXPECT_EQ(far.rig.interventions(), 0U);
  Meeting near(-1e-3F);
  near.rig.tick();
  EXPECT_LT(near.rig.command(0).x, 1.0F);
  EXPECT_EQ(near.rig.count(GovernorReason::kNeighbour), 1U);
  EXPECT_FALSE(near.rig.symptoms[0].has(Symptom::kTooNear));
}

TEST(GovernorPairs, TubesAreKeptAsWell) {
  GovernorConfig config = default_config(2);
  config.groups[0].limits.tube = 0.01F;
  Meeting near(0.02F - 1e-3F, config);
  near.rig.tick();
  EXPECT_EQ(near.rig.count(GovernorReason::kNeighbour), 1U);
  Meeting far(0.02F + 1e-3F, config);
  far.rig.tick();
  EXPECT_EQ(far.rig.interventions(), 0U);
}

TEST(GovernorPairs, OneAboveTheOtherKeepsADownwash) {
  for (const float height : {0.55F, 0.65F}) {
    GovernorConfig config = default_config(2);
    config.groups[0].limits.downwash = 3.0F;
    config.groups[0].count = 1;
    config.groups.push_back(config.groups[0]);
    config.groups[1].first = 1;
    config.groups[1].limits.downwash = 1.0F;  // the taller of the two counts
    Rig rig(config);
    rig.place(1, {0, 0, height}, {0, 0, 0});
    rig.tick();
    EXPECT_EQ(rig.symptoms[0].has(Symptom::kTooNear), height < 0.6F);
    EXPECT_EQ(rig.symptoms[1].has(Symptom::kTooNear), height < 0.6F);
  }
}

TEST(GovernorPairs, TheTooNearMayOnlyMoveApart) {
  Rig rig(default_config(2));
  rig.place(1, {0.15F, 0, 0}, {0, 0, 0});
  rig.desire(0, {0.04F, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(0.0F));
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTooNear));
  EXPECT_TRUE(rig.symptoms[1].has(Symptom::kTooNear));
  EXPECT_EQ(rig.count(GovernorReason::kNeighbour), 1U);
  rig.desire(0, {-0.04F, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(-0.04F, 0, 0));
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTooNear));
  EXPECT_EQ(rig.count(GovernorReason::kNeighbour), 1U);
}

// 0.3 m above counts as 0.1 m: apart is what leads away as it is measured so.
TEST(GovernorPairs, ApartIsWhereTheDownwashSaysSo) {
  for (const float sign : {1.0F, -1.0F}) {
    GovernorConfig config = default_config(2);
    config.groups[0].limits.downwash = 3.0F;
    Rig rig(config);
    rig.place(1, {0.1F, 0, 0.3F}, {0, 0, 0});
    const glm::vec3 wish = sign * glm::vec3(-0.02F, 0, 0.03F);
    rig.desire(0, wish);
    rig.tick();
    EXPECT_EQ(rig.command(0), sign > 0.0F ? wish : glm::vec3(0.0F));
  }
}

// There is room for one of the two: who has it changes with the tick.
TEST(GovernorPairs, WhoComesFirstIsAnotherEachTick) {
  std::array<int, 2> first{};
  for (int before = 0; before < 2; ++before) {
    Rig rig(default_config(2));
    rig.place(1, {0.2012F, 0, 0}, {0, 0, 0});
    for (int n = 0; n < before; ++n) {
      rig.tick({0, 0, 0});
    }
    rig.desire(1, {-0.04F, 0, 0});
    rig.tick({0.04F, 0, 0});
    EXPECT_EQ(rig.count(GovernorReason::kNeighbour), 1U);
    first[0] += rig.ox[0] == 0.04F ? 1 : 0;
    first[1] += rig.ox[1] == -0.04F ? 1 : 0;
    EXPECT_FLOAT_EQ(std::min(rig.ox[0], -rig.ox[1]), 0.02F) << "for half of it there is";
  }
  EXPECT_EQ(first[0], 1);
  EXPECT_EQ(first[1], 1);
}

TEST(GovernorPairs, WhereTwoReservationsMeetTheirPlacesTellTheWayApart) {
  Rig rig(default_config(2));
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.place(1, {0.1F, 0, 0}, {-1, 0, 0});
  for (int i = 0; i < 100; ++i) {
    const float away = rig.x[0] < rig.x[1] ? 2.0F : -2.0F;  // they cannot but pass through each other
    rig.desire(0, {-away, 0, 0});
    rig.desire(1, {away, 0, 0});
    rig.tick();
    rig.now += 10ms;
    for (const std::size_t robot : {0U, 1U}) {
      rig.fly(robot);
    }
  }
  EXPECT_GT(std::fabs(rig.x[1] - rig.x[0]), 0.2F);
  EXPECT_FALSE(rig.symptoms[0].has(Symptom::kTooNear));
}

TEST(GovernorPairs, TwoInOnePlaceStay) {
  Rig rig(default_config(2));
  rig.desire(0, {0.04F, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(0.0F));
}

TEST(GovernorPairs, NobodyMindsTheAbsentNorAnUngovernedSwarm) {
  Rig rig(default_config(2));
  rig.place(1, {0.15F, 0, 0}, {0, 0, 0});
  rig.authority[1] = Authority::kAbsent;
  rig.desire(0, {0.04F, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(0.04F, 0, 0));
  EXPECT_EQ(rig.kind[1], CommandKind::kHold);
  EXPECT_TRUE(rig.symptoms[0].empty());
  GovernorConfig config = default_config(1);
  config.groups.push_back({.first = 1, .count = 1, .limits = config.groups[0].limits, .enabled = false});
  Rig mixed(config);
  mixed.place(1, {0.15F, 0, 0}, {0, 0, 0});
  mixed.authority[1] = Authority::kForeign;
  mixed.desire(0, {0.04F, 0, 0});
  mixed.tick();
  EXPECT_EQ(mixed.command(0), glm::vec3(0.04F, 0, 0));
}

TEST(GovernorPairs, OneAtRestStandsWhereItIsSeenAndHolds) {
  Rig rig(default_config(2));
  rig.place(1, {5, 0, 0}, {0, 0, 0});
  rig.authority[1] = Authority::kAtRest;
  rig.desire(1, {1, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.kind[1], CommandKind::kHold);
  rig.place(1, {0.3F, 0, 0}, {0, 0, 0});  // carried there by hand
  rig.place(0, {0, 0, 0}, {0, 0, 0});
  rig.desire(0, {0.04F, 0, 0});
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(0.04F, 0, 0));
  rig.known[1] = 0;  // and it stays there, as far as anybody knows
  for (int i = 0; i < 100; ++i) {
    rig.desire(0, {2, 0, 0});
    rig.tick();
    rig.fly(0);
  }
  EXPECT_LE(rig.x[0], 0.1F);
  EXPECT_GE(rig.count(GovernorReason::kNeighbour), 1U);
  rig.authority[1] = Authority::kGoverned;  // it takes off from where it is seen
  rig.known[1] = 1;
  rig.tick();
  EXPECT_NEAR(rig.governor.reference(1).body.x, 0.3, 1e-6);
}

TEST(GovernorPairs, OrderedToBrakeARobotBrakesThenHolds) {
  Rig rig(default_config(1));
  rig.place(0, {0, 0, 0}, {0.05F, 0, 0});
  rig.authority[0] = Authority::kBraking;
  EXPECT_NEAR(rig.tick({2, 0, 0}).x, 0.01F, 1e-6F);
  EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
  EXPECT_EQ(rig.tick({2, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_EQ(rig.count(GovernorReason::kOrdered), 2U);
  rig.authority[0] = Authority::kGoverned;
  EXPECT_NEAR(rig.tick({2, 0, 0}).x, 0.04F, 1e-6F);
}

// What it may do alone was reserved for it, and stays so.
TEST(GovernorPairs, ASilentRobotKeepsWhatItHad) {
  GovernorConfig config = default_config(2);
  config.groups[0].limits.watchdog = 0.1F;
  config.groups[0].limits.tube = 0.02F;
  Rig rig(config);
  rig.place(0, {0, 0, 0}, {1, 0, 0});
  rig.place(1, {0.6F, 0, 0}, {0, 0, 0});
  rig.desire(0, {1, 0, 0});
  rig.tick();
  rig.authority[0] = Authority::kSilent;
  rig.known[0] = 0;
  for (int i = 0; i < 200; ++i) {
    rig.now += 10ms;
    rig.desire(1, {-2, 0, 0});
    rig.tick();
    rig.fly(1);
  }
  // It may have flown 0.01 m as told, 0.1 m unheard, 0.125 m to rest: its neighbour does not come nearer.
  EXPECT_GE(rig.x[1], 0.01 + 0.1 + 0.125 + 0.2);
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_GE(rig.count(GovernorReason::kOrdered), 200U);
  rig.authority[0] = Authority::kGoverned;  // heard again, but not yet seen
  EXPECT_EQ(rig.tick({1, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_GE(rig.governor.reference(1).body.x, 0.43);
  rig.known[0] = 1;
  rig.place(0, {0.2F, 0.009F, 0}, {0, 0, 0});
  rig.tick();
  EXPECT_NEAR(rig.governor.reference(0).body.x, 0.2, 1e-6) << "somewhere in what it had";
  EXPECT_NEAR(rig.governor.reference(0).body.y, 0.0, 1e-6) << "and nowhere else";
}

TEST(GovernorPairs, AForeignRobotIsABallThatGrowsWhileItIsNotSeen) {
  Rig rig(default_config(2));
  rig.place(0, {0, 0, 0}, {0, 0, 0});
  rig.place(1, {0.6F, 0, 0}, {1, 0, 0});
  rig.authority[1] = Authority::kForeign;
  rig.desire(0, {0, 0.04F, 0});
  rig.tick();
  EXPECT_EQ(rig.kind[1], CommandKind::kNone);
  EXPECT_EQ(rig.command(0), glm::vec3(0, 0.04F, 0));
  rig.known[1] = 0;
  for (int i = 0; i < 40; ++i) {  // in 0.4 s it may have come 0.72 m
    rig.now += 10ms;
    rig.desire(0, {0, 0, 0});
    rig.tick();
  }
  EXPECT_TRUE(rig.symptoms[0].has(Symptom::kTooNear));
  rig.known[1] = 1;
  rig.tick();
  EXPECT_FALSE(rig.symptoms[0].has(Symptom::kTooNear));
}

// It goes on while the other comes to rest: at 4 m/s² for 0.26 s, 0.135 m.
TEST(GovernorPairs, AForeignRobotMovesWhileOursBrakes) {
  for (const float gap : {0.13F, 0.14F}) {
    Meeting meeting(gap);
    meeting.rig.authority[1] = Authority::kForeign;
    meeting.rig.tick();
    EXPECT_EQ(meeting.rig.count(GovernorReason::kNeighbour), gap < 0.135F ? 1U : 0U);
  }
}

// It may begin to fly at any time: in 0.41 s at 4 m/s² it gets 0.336 m far.
TEST(GovernorPairs, AForeignRobotThatStandsMayAccelerate) {
  for (const float away : {0.52F, 0.55F}) {
    Rig rig(default_config(2));
    rig.place(1, {away, 0, 0}, {0, 0, 0});
    rig.authority[1] = Authority::kForeign;
    rig.tick({0, 0, 0});
    rig.known[1] = 0;
    for (int i = 0; i < 40; ++i) {
      rig.tick({0, 0, 0});
    }
    EXPECT_EQ(rig.symptoms[0].has(Symptom::kTooNear), away < 0.53F);
  }
}

}  // namespace
}  // namespace mayfly::governor_test
