#include "controller/flight/swarm_models.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::SizeIs;

float enforced(const Scenario& scenario, bool in_real_time = false) {
  return make_swarm_models(scenario, world_of(scenario), in_real_time).swarms.at(0).separation;
}

Scenario governed_by(PlantKind plant, bool governor) {
  Scenario scenario = hall(4);
  scenario.hals[0].sim.plant = plant;
  scenario.swarms[0].governor = governor;
  return scenario;
}

TEST(SwarmModels, CoverTheAgentsOneSwarmAfterTheOther) {
  Scenario scenario = hall(3);
  scenario.swarms.assign(3, scenario.swarms[0]);
  scenario.swarms[1].count = 0;
  scenario.swarms[2].count = 5;
  const World world = world_of(scenario);
  const SwarmModels models = make_swarm_models(scenario, world);
  ASSERT_THAT(models.swarms, SizeIs(3));
  EXPECT_EQ(models.swarms[0].first, 0U);
  EXPECT_EQ(models.swarms[1].first, 3U);
  EXPECT_EQ(models.swarms[1].count, 0U);
  EXPECT_EQ(models.swarms[2].first, 3U);
  EXPECT_EQ(models.swarms[2].count, 5U);
  EXPECT_EQ(models.agents(), 8U);
  EXPECT_THAT(models.swarms[2].rest.z, SizeIs(5));
  EXPECT_EQ(models.swarms[2].rest.x.data(), models.rest[2].x.data());
  EXPECT_EQ(models.swarms[0].guide.data(), world.costs[0]->guide.data());
  EXPECT_EQ(SwarmModels{}.agents(), 0U);
}

TEST(SwarmModels, SayWhatTheScenarioSays) {
  Scenario scenario = walled_hall(2);
  SwarmSpec& swarm = scenario.swarms[0];
  swarm.cruise_speed = 1.25F;
  swarm.radius = 0.125F;
  swarm.boundary = 0.75F;
  swarm.mde_sweeps = 11;
  swarm.noise.octaves = {{2.0F, 0.5F}, {4.0F, 0.25F}};
  const World world = world_of(scenario);
  const SwarmModels models = make_swarm_models(scenario, world);
  const kernels::MfField& field = models.swarms[0].field;
  EXPECT_EQ(field.cruise_speed, 1.25F);
  EXPECT_EQ(field.radius, 0.125F);
  EXPECT_EQ(field.boundary, 0.75F);
  EXPECT_EQ(models.swarms[0].mde_sweeps, 11);
  EXPECT_EQ(field.has_walls, 1);
  EXPECT_EQ(field.has_noise, 1);
  EXPECT_EQ(field.noise.octaves, 2);
  EXPECT_EQ(field.noise.inverse_scale[1], 0.25F);
  EXPECT_EQ(field.noise.gain[0], 0.5F);
  EXPECT_EQ(field.grid.nx, 12);
  EXPECT_EQ(field.grid.ny, 20);
}

TEST(SwarmModels, KnowNoWallsInAnEmptyWorldAndNoNoiseWhereItIsOff) {
  Scenario scenario = hall(1);
  scenario.swarms[0].noise.kind = NoiseKind::kNone;
  const SwarmModels models = make_swarm_models(scenario, world_of(scenario));
  EXPECT_EQ(models.swarms[0].field.has_walls, 0);
  EXPECT_EQ(models.swarms[0].field.has_noise, 0);
  EXPECT_EQ(models.swarms[0].field.boundary, 1.0F) << "one cell where nothing is said";
}

TEST(SwarmModels, GiveEachSwarmAndEachSeedItsOwnNoise) {
  Scenario scenario = hall(1);
  scenario.swarms.push_back(scenario.swarms[0]);
  const World world = world_of(scenario);
  const SwarmModels models = make_swarm_models(scenario, world);
  EXPECT_NE(models.swarms[0].field.noise.seed, models.swarms[1].field.noise.seed);
  scenario.seed = 6;
  EXPECT_NE(models.swarms[0].field.noise.seed, make_swarm_models(scenario, world).swarms[0].field.noise.seed);
}

TEST(EnforcedDistance, IsAHairMoreThanTheSeparationOfIdealPoints) {
  const float distance = enforced(governed_by(PlantKind::kIdeal, false));
  EXPECT_GT(distance, 0.2F);
  EXPECT_LT(distance, 0.202F);
}

TEST(EnforcedDistance, GrowsWithTheWorldsRounding) {
  Scenario far = governed_by(PlantKind::kIdeal, false);
  far.world.bounds.max.y = 200.0F;
  // A float near 200 m is good to 2⁻¹⁶ m; a step and its sum may be off by some of these.
  EXPECT_GE(enforced(far) - enforced(governed_by(PlantKind::kIdeal, false)), 2.0F * 0x1p-16F);
}

TEST(EnforcedDistance, AllowsForWhatALagTrailsBy) {
  Scenario scenario = governed_by(PlantKind::kVelocityLag, false);
  scenario.hals[0].sim.time_constant = 0.2F;
  EXPECT_NEAR(enforced(scenario), 0.2F + 0.2F * 1.5F, 1e-3F);
  scenario.hals[0].sim.delay = 0.1F;
  EXPECT_NEAR(enforced(scenario), 0.2F + 0.3F * 1.5F, 1e-3F);
}

TEST(EnforcedDistance, AllowsForTheWayThatATurnTakes) {
  Scenario scenario = governed_by(PlantKind::kDoubleIntegrator, false);
  scenario.swarms[0].limits.acceleration = 5.0F;
  scenario.swarms[0].noise.octaves = {{.scale = 0.5F, .gain = 0.25F}};
  const float speed_squared = 1.5F * 1.5F + 0.859F * 0.859F;  // cruise, and the rms of 1.718 · gain / scale
  EXPECT_NEAR(enforced(scenario), 0.2F + speed_squared / 5.0F, 1e-3F);
  scenario.hals[0].sim.plant = PlantKind::kIdeal;
  scenario.swarms[0].governor = true;
  EXPECT_NEAR(enforced(scenario), 0.2F + speed_squared / 5.0F, 1e-3F);
}

TEST(EnforcedDistance, AllowsForAPeriodOfEachSideInRealTime) {
  const Scenario scenario = governed_by(PlantKind::kIdeal, false);
  EXPECT_NEAR(enforced(scenario, true) - enforced(scenario, false), 1.5F * (0.01F + 0.005F), 1e-4F);
}

TEST(EnforcedDistance, IsNoneWhereNoneIsAskedFor) {
  Scenario scenario = governed_by(PlantKind::kVelocityLag, true);
  scenario.swarms[0].limits.separation = 0.0F;
  EXPECT_EQ(enforced(scenario), 0.0F);
}

TEST(ResponseTime, IsLagAndDelayOfTheSwarmsOwnHal) {
  Scenario scenario = hall(1);
  scenario.hals.push_back({"slow", {}});
  scenario.hals[1].sim.plant = PlantKind::kVelocityLag;
  scenario.hals[1].sim.time_constant = 0.25F;
  scenario.hals[1].sim.delay = 0.5F;
  EXPECT_EQ(response_time(scenario, scenario.swarms[0]), 0.0F);
  scenario.swarms[0].robots = "slow";
  EXPECT_EQ(response_time(scenario, scenario.swarms[0]), 0.75F);
  scenario.swarms[0].robots = "nowhere";
  EXPECT_EQ(response_time(scenario, scenario.swarms[0]), 0.0F);
}

// A command that holds for a whole period must not carry an agent past the wall.
TEST(ApproachRate, NeverUsesUpTheClearanceInAPeriod) {
  for (const float rate : {1.0F, 10.0F, 19.0F, 20.0F, 100.0F, 1000.0F}) {
    Scenario scenario = walled_hall(1);
    scenario.control.rate = rate;
    const float approach = make_swarm_models(scenario, world_of(scenario)).swarms.at(0).field.approach_rate;
    EXPECT_GT(approach, 0.0F);
    EXPECT_LE(approach, 0.25F * rate);
    EXPECT_LE(approach, 5.0F);
  }
}

TEST(GoalMargin, IsNeverDeeperThanHalfTheGoal) {
  Scenario scenario = hall(1);
  const auto margin = [&] {
    return make_swarm_models(scenario, world_of(scenario)).swarms.at(0).field.goal_margin;
  };
  EXPECT_GT(margin(), 0.0F);
  EXPECT_LE(margin(), 1.5F);  // the goal is 6 m deep: 3 m to its middle
  scenario.world.goals[0].shape = fields::SphereShape{{6, 15, 6}, 0.1F};
  EXPECT_GT(margin(), 0.0F);
}

}  // namespace
}  // namespace mayfly::test
