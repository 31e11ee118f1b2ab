// Each reason fires, and does not fire one step below its threshold.
#include <cmath>
#include <limits>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

Rig cruising(float speed, GovernorConfig config = default_config(1)) {
  Rig rig(config);
  rig.place(0, {0, 0, 0}, {speed, 0, 0});
  return rig;
}

TEST(GovernorReasons, WhatIsLegalPassesUnchanged) {
  Rig rig = cruising(1.0F);
  EXPECT_EQ(rig.tick({1.0F, 0.02F, 0.0F}), glm::vec3(1.0F, 0.02F, 0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
  EXPECT_EQ(rig.interventions(), 0U);
  EXPECT_EQ(rig.governor.counters().ticks, 1U);
}

TEST(GovernorReasons, WhatIsNotANumberBrakes) {
  for (const glm::vec3 hostile : {glm::vec3(kNan, 0, 0), glm::vec3(0, kInfinity, 0),
                                  glm::vec3(0, 0, -kInfinity), glm::vec3(kNan, kNan, kNan)}) {
    Rig rig = cruising(1.0F);
    EXPECT_NEAR(rig.tick(hostile).x, 0.96F, 1e-6F);
    EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
    EXPECT_EQ(rig.count(GovernorReason::kNotFinite), 1U);
    EXPECT_EQ(rig.interventions(), 1U);
  }
}

TEST(GovernorReasons, TheLargestNumberIsOnlyTooFast) {
  for (const float huge : {1e30F, kLargest}) {
    Rig rig = cruising(2.0F);
    EXPECT_NEAR(rig.tick({huge, 0, 0}).x, 2.0F, 1e-6F);
    EXPECT_EQ(rig.count(GovernorReason::kNotFinite), 0U);
    EXPECT_EQ(rig.count(GovernorReason::kSpeed), 1U);
    EXPECT_EQ(rig.count(GovernorReason::kAcceleration), 0U);
  }
}

TEST(GovernorReasons, AnInvalidStateBrakesToHold) {
  Rig rig = cruising(0.1F);
  rig.tick({0.1F, 0, 0});
  EXPECT_EQ(rig.interventions(), 0U);
  rig.known[0] = 0;
  EXPECT_NEAR(rig.tick({0.1F, 0, 0}).x, 0.06F, 1e-6F);
  EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
  EXPECT_NEAR(rig.tick({0.1F, 0, 0}).x, 0.02F, 1e-6F);
  EXPECT_EQ(rig.tick({0.1F, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_EQ(rig.count(GovernorReason::kUnknown), 3U);
  rig.known[0] = 1;  // and it clears, from rest
  EXPECT_NEAR(rig.tick({0.1F, 0, 0}).x, 0.04F, 1e-6F);
  EXPECT_EQ(rig.kind[0], CommandKind::kVelocity);
  EXPECT_EQ(rig.count(GovernorReason::kUnknown), 3U);
}

TEST(GovernorReasons, AStateThatIsNotFiniteIsInvalid) {
  for (int field = 0; field < 6; ++field) {
    Rig rig = cruising(0.0F);
    std::vector<float>* columns[] = {&rig.x, &rig.y, &rig.z, &rig.vx, &rig.vy, &rig.vz};
    (*columns[field])[0] = field % 2 == 0 ? kNan : kInfinity;
    rig.tick({0.01F, 0, 0});
    EXPECT_EQ(rig.kind[0], CommandKind::kHold);
    EXPECT_EQ(rig.count(GovernorReason::kUnknown), 1U);
    Rig seen = cruising(0.0F);  // and no less so once it has a reference
    seen.tick({0.01F, 0, 0});
    std::vector<float>* later[] = {&seen.x, &seen.y, &seen.z, &seen.vx, &seen.vy, &seen.vz};
    (*later[field])[0] = field % 2 == 0 ? kNan : kInfinity;
    EXPECT_EQ(seen.tick({0.01F, 0, 0}), glm::vec3(0.0F)) << field;
    EXPECT_EQ(seen.count(GovernorReason::kUnknown), 1U) << field;
  }
}

TEST(GovernorReasons, ARobotThatWasNeverSeenHolds) {
  Rig rig = cruising(1.0F);
  rig.known[0] = 0;
  EXPECT_EQ(rig.tick({1.0F, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  rig.known[0] = 1;  // its first valid state tells how fast it is
  EXPECT_EQ(rig.tick({1.0F, 0, 0}), glm::vec3(1.0F, 0, 0));
}

TEST(GovernorReasons, AnImpossibleFirstSpeedIsNotBelieved) {
  Rig believed = cruising(20.0F);
  EXPECT_NEAR(believed.tick({1.0F, 0, 0}).x, 19.96F, 1e-5F);
  Rig rig = cruising(20.1F);
  EXPECT_EQ(rig.tick({1.0F, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.kind[0], CommandKind::kHold);
  EXPECT_EQ(rig.count(GovernorReason::kUnknown), 1U);
}

TEST(GovernorReasons, SpeedFiresAboveItsLimitOnly) {
  Rig rig = cruising(2.0F);
  EXPECT_EQ(rig.tick({2.0F, 0, 0}), glm::vec3(2.0F, 0, 0));
  EXPECT_EQ(rig.interventions(), 0U);
  EXPECT_NEAR(rig.tick({2.0001F, 0, 0}).x, 2.0F, 1e-6F);
  EXPECT_EQ(rig.count(GovernorReason::kSpeed), 1U);
  EXPECT_EQ(rig.interventions(), 1U);
}

TEST(GovernorReasons, ADiagonalOfTheLimitsLengthIsLegal) {
  Rig rig(default_config(1));
  const glm::vec3 diagonal = 2.0F * glm::normalize(glm::vec3(1, -2, 3));
  rig.place(0, {0, 0, 0}, diagonal);
  EXPECT_EQ(rig.tick(diagonal), diagonal);
  EXPECT_EQ(rig.interventions(), 0U);
}

TEST(GovernorReasons, AccelerationFiresAboveItsLimitOnly) {
  Rig rig = cruising(1.0F);
  EXPECT_EQ(rig.tick({1.0F, 0.04F, 0}), glm::vec3(1.0F, 0.04F, 0));
  EXPECT_EQ(rig.count(GovernorReason::kAcceleration), 0U);
  const glm::vec3 sharp = rig.tick({1.0F, 0.0801F, 0});
  EXPECT_NEAR(sharp.y, 0.08F, 1e-6F);
  EXPECT_EQ(rig.count(GovernorReason::kAcceleration), 1U);
}

TEST(GovernorReasons, OneTickMayHaveTwoReasonsAndIsOneIntervention) {
  Rig rig = cruising(0.0F);
  rig.tick({5.0F, 0, 0});
  EXPECT_EQ(rig.count(GovernorReason::kSpeed), 1U);
  EXPECT_EQ(rig.count(GovernorReason::kAcceleration), 1U);
  EXPECT_EQ(rig.interventions(), 1U);
}

// Nothing above the limit is taken away at once: that would break the acceleration limit.
TEST(GovernorReasons, AnOverSpeedStartBrakesUntilItIsLegal) {
  Rig rig = cruising(3.0F);
  double speed = 3.0;
  int ticks = 0;
  while (speed > 2.0 + 1e-5) {
    const double next = rig.tick({3.0F, 1.0F, 0}).x;
    ASSERT_NEAR(speed - next, 0.04, 1e-6);
    speed = next;
    ASSERT_LT(++ticks, 26);
  }
  EXPECT_EQ(ticks, 25);
  EXPECT_EQ(rig.count(GovernorReason::kSpeed), 25U);
  rig.tick({static_cast<float>(speed), 0, 0});
  EXPECT_EQ(rig.interventions(), 25U);
}

TEST(GovernorReasons, TheFenceFiresWhereTheStopWouldNotFit) {
  // From 1 m/s with 4 m/s²: 0.125 m and 5e-5 m to stop, 0.01 m in the tick, 0.1 m the body.
  const float edge = 10.0F - 0.1F - 0.125F - 0.00005F - 0.01F;
  Rig inside = cruising(1.0F);
  inside.place(0, {edge - 1e-4F, 0, 0}, {1.0F, 0, 0});
  EXPECT_EQ(inside.tick({1.0F, 0, 0}), glm::vec3(1.0F, 0, 0));
  EXPECT_EQ(inside.interventions(), 0U);
  Rig outside = cruising(1.0F);
  outside.place(0, {edge + 1e-4F, 0, 0}, {1.0F, 0, 0});
  EXPECT_LT(outside.tick({1.0F, 0, 0}).x, 1.0F);
  EXPECT_EQ(outside.count(GovernorReason::kFence), 1U);
  EXPECT_EQ(outside.interventions(), 1U);
}

TEST(GovernorReasons, BrakingAsWantedIsNoIntervention) {
  Rig rig = cruising(1.0F);
  rig.place(0, {9.8F, 0, 0}, {1.0F, 0, 0});  // it cannot but brake, and this is what is asked for
  EXPECT_NEAR(rig.tick({0.96F, 0, 0}).x, 0.96F, 1e-6F);
  EXPECT_EQ(rig.interventions(), 0U);
}

TEST(GovernorReasons, OutsideTheFenceOnlyTheWayBackIsFree) {
  Rig rig = cruising(0.0F);
  rig.place(0, {11.0F, 0, 0}, {0, 0, 0});
  EXPECT_EQ(rig.tick({0.04F, 0, 0}), glm::vec3(0.0F));
  EXPECT_EQ(rig.count(GovernorReason::kFence), 1U);
  EXPECT_EQ(rig.tick({-0.04F, 0.0F, 0}), glm::vec3(-0.04F, 0, 0));
  EXPECT_EQ(rig.count(GovernorReason::kFence), 1U);
}

// A wall at x = 1: φ = 1 − x, which interpolation meets exactly, up to its proven error bound.
struct Wall {
  std::vector<float> data;
  Grid grid{{-5.0F, -5.0F, -5.0F}, 0.5F, {20, 20, 20}};
  Wall() {
    data.resize(grid.size());
    for (int k = 0; k < 20; ++k) {
      for (int j = 0; j < 20; ++j) {
        for (int i = 0; i < 20; ++i) {
          data[grid.index(i, j, k)] = 1.0F - grid.center(i, j, k).x;
        }
      }
    }
  }
  GovernorConfig config(bool exact) const {
    GovernorConfig c = default_config(1);
    c.obstacles.sampled = {data.data(), grid};
    if (exact) {
      c.obstacles.exact = [](glm::vec3 p) { return 1.0F - p.x; };
    }
    return c;
  }
};

TEST(GovernorReasons, AnObstacleFiresWhereTheStopWouldNotFit) {
  const Wall wall;
  // The stop and the body as at the fence; a tenth of the body and 0.25 mm for the chord are kept besides.
  const float edge = 1.0F - 0.1F - 0.125F - 0.00005F - 0.01F - 0.01F - 0.00025F;
  Rig inside = cruising(1.0F, wall.config(true));
  inside.place(0, {edge - 1e-3F, 0, 0}, {1.0F, 0, 0});
  EXPECT_EQ(inside.tick({1.0F, 0, 0}), glm::vec3(1.0F, 0, 0));
  EXPECT_EQ(inside.interventions(), 0U);
  Rig outside = cruising(1.0F, wall.config(true));
  outside.place(0, {edge + 1e-3F, 0, 0}, {1.0F, 0, 0});
  EXPECT_LT(outside.tick({1.0F, 0, 0}).x, 1.0F);
  EXPECT_EQ(outside.count(GovernorReason::kObstacle), 1U);
  EXPECT_EQ(outside.count(GovernorReason::kFence), 0U);
}

TEST(GovernorReasons, WithoutTheExactDistanceTheFieldsErrorIsKeptToo) {
  const Wall wall;
  Rig rig = cruising(1.0F, wall.config(false));
  rig.place(0, {0.5F, 0, 0}, {1.0F, 0, 0});  // 0.27 m would do; half a cell's diagonal is 0.43 m
  EXPECT_LT(rig.tick({1.0F, 0, 0}).x, 1.0F);
  EXPECT_EQ(rig.count(GovernorReason::kObstacle), 1U);
  Rig far = cruising(1.0F, wall.config(false));
  far.place(0, {0.1F, 0, 0}, {1.0F, 0, 0});
  far.tick({1.0F, 0, 0});
  EXPECT_EQ(far.interventions(), 0U);
}

TEST(GovernorReasons, FromAWallEveryWayBackIsFree) {
  const Wall wall;
  for (const float x : {0.89F, 0.9F, 0.95F, 1.2F}) {
    Rig rig = cruising(0.0F, wall.config(true));
    rig.place(0, {x, 0, 0}, {0, 0, 0});
    EXPECT_EQ(rig.tick({0.02F, 0, 0}), glm::vec3(0.0F)) << x;
    EXPECT_EQ(rig.tick({0.0F, 0.02F, 0}), glm::vec3(0.0F)) << x;
    EXPECT_EQ(rig.tick({-0.02F, 0.02F, 0}), glm::vec3(-0.02F, 0.02F, 0)) << x;
  }
}

TEST(GovernorReasons, OffLeavesFiniteChecksStateChecksAndTheSpeedLimit) {
  GovernorConfig config = default_config(1);
  config.groups[0].enabled = false;
  Rig rig(config);
  rig.place(0, {9.99F, 0, 0}, {0, 0, 0});
  EXPECT_EQ(rig.tick({2.0F, 0, 0}), glm::vec3(2.0F, 0, 0));  // sudden, and into the fence
  EXPECT_EQ(rig.interventions(), 0U);
  EXPECT_NEAR(rig.tick({0.0F, 3.0F, 0}).y, 2.0F, 1e-6F);
  EXPECT_EQ(rig.count(GovernorReason::kSpeed), 1U);
  EXPECT_NEAR(rig.tick({kNan, 0, 0}).y, 1.96F, 1e-6F);
  EXPECT_EQ(rig.count(GovernorReason::kNotFinite), 1U);
  rig.known[0] = 0;
  EXPECT_NEAR(rig.tick({0, 0, 0}).y, 1.92F, 1e-6F);
  EXPECT_EQ(rig.count(GovernorReason::kUnknown), 1U);
}

TEST(GovernorReasons, EachSwarmHasItsOwnLimits) {
  GovernorConfig config = default_config(2);
  config.groups[0].count = 1;
  config.groups.push_back(config.groups[0]);
  config.groups[1].first = 1;
  config.groups[1].limits.speed = 1.0F;
  Rig rig(config);
  for (const std::size_t i : {0U, 1U}) {
    rig.place(i, {0, static_cast<float>(i), 0}, {1, 0, 0});
    rig.desire(i, {1.03F, 0, 0});
  }
  rig.tick();
  EXPECT_EQ(rig.command(0), glm::vec3(1.03F, 0, 0));
  EXPECT_NEAR(rig.command(1).x, 1.0F, 1e-6F);
  EXPECT_EQ(rig.interventions(), 1U);
}

TEST(GovernorReasons, ShortColumnsAreRefusedAndEveryRobotHolds) {
  Rig rig(default_config(3));
  rig.wy.pop_back();
  rig.tick();
  EXPECT_EQ(rig.governor.counters().refused_calls, 1U);
  for (const CommandKind kind : rig.kind) {
    EXPECT_EQ(kind, CommandKind::kHold);
  }
}

TEST(GovernorReasons, ShortRowsOfAnyKindAreRefused) {
  for (int row = 0; row < 4; ++row) {
    Rig rig(default_config(3));
    row == 0   ? rig.known.pop_back()
    : row == 1 ? rig.kind.pop_back()
    : row == 2 ? rig.authority.pop_back()
               : rig.symptoms.pop_back();
    rig.tick();
    EXPECT_EQ(rig.governor.counters().refused_calls, 1U) << row;
  }
  Rig rig(default_config(1));  // nobody asks for symptoms, and all are governed
  rig.symptoms.clear();
  rig.authority.clear();
  rig.tick({0.01F, 0, 0});
  EXPECT_EQ(rig.governor.counters().refused_calls, 0U);
}

TEST(GovernorReasons, AnOverSpeedStartThatWantsToBrakeIsLeftAlone) {
  Rig rig = cruising(3.0F);
  EXPECT_NEAR(rig.tick({2.96F, 0, 0}).x, 2.96F, 1e-6F);
  EXPECT_EQ(rig.interventions(), 1U);  // the wish is above the limit all the same
}

TEST(GovernorReasons, NoAgentsIsNoWork) {
  GovernorConfig config = default_config(0);
  Rig rig(config);
  rig.tick();
  config.groups.clear();
  Rig none(config);
  none.tick();
  EXPECT_EQ(none.governor.counters().ticks, 1U);
  EXPECT_EQ(none.interventions(), 0U);
}

TEST(GovernorReasons, ATickAllocatesNothing) {
  const Wall wall;
  Rig rig(wall.config(true));
  rig.place(0, {0.8F, 0, 0}, {1, 0, 0});
  const std::uint64_t before = allocation_count();
  for (int i = 0; i < 100; ++i) {
    rig.tick({1.0F, kNan, 0});
    rig.tick({1.0F, 0, 0});
  }
  EXPECT_EQ(allocation_count(), before);
}

TEST(GovernorConfig, ContradictionsAreRefused) {
  const auto refused = [](auto change) {
    GovernorConfig config = default_config(2);
    change(config);
    const auto made = Governor::make(config);
    EXPECT_TRUE(made || !made.error().wanted.empty());
    return !made;
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_TRUE(refused([](auto& c) { c.period = Time{0}; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.speed = 0.0F; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.speed = kNan; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.acceleration = kInfinity; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.braking = 4.1F; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.braking = 0.0F; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.radius = -0.1F; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].limits.tube = kNan; }));
  EXPECT_TRUE(refused([](auto& c) { c.groups[0].first = 1; }));
  EXPECT_TRUE(refused([](auto& c) { c.fence.max.y = -9.9F; }));
  EXPECT_TRUE(refused([](auto& c) { c.fence.max.y = kNan; }));
  EXPECT_FALSE(refused([](auto& c) {
    c.fence.max.y = -9.9F;  // nobody is fenced
    c.groups[0].enabled = false;
  }));
  float nothing = 0.0F;
  EXPECT_TRUE(refused([&](auto& c) { c.obstacles.sampled = {&nothing, Grid{}}; }));
  EXPECT_TRUE(refused([&](auto& c) {
    c.obstacles.sampled = {&nothing, Grid{glm::vec3(0.0F), 0.0F, {1, 1, 1}}};
  }));
  for (const glm::ivec3 cells : {glm::ivec3(0, 1, 1), glm::ivec3(1, 0, 1), glm::ivec3(1, 1, 0)}) {
    EXPECT_TRUE(refused([&](auto& c) {
      c.obstacles.sampled = {&nothing, Grid{glm::vec3(0.0F), 1.0F, cells}};
    }));
  }
}

}  // namespace
}  // namespace mayfly::governor_test
