#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

namespace fs = std::filesystem;

// A folder of its own with the example and its mesh.
class Example : public testing::Test {
 protected:
  Example() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("mayfly_example_") + info->name() + "_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "meshes");
    std::ofstream(folder_ / "meshes" / "block.obj") << "v 0 0 0\n";
    std::ofstream(folder_ / "two_blocks.yaml") << test::kExample;
  }
  ~Example() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(Example, LoadsAsItStandsInTheInterface) {
  const auto result = load_scenario(folder_ / "two_blocks.yaml");
  ASSERT_TRUE(result) << test::all_text(result.error());
  const Scenario& scenario = *result;
  EXPECT_EQ(scenario.name, "two_blocks");
  EXPECT_EQ(scenario.seed, 7U);
  EXPECT_EQ(scenario.duration, 40.0);
  EXPECT_EQ(scenario.world.bounds.max, glm::vec3(60.0F, 112.0F, 40.0F));
  ASSERT_EQ(scenario.world.obstacles.size(), 1U);
  const auto& mesh = std::get<fields::MeshShape>(scenario.world.obstacles[0].shape);
  EXPECT_EQ(mesh.file, fs::canonical(folder_) / "meshes" / "block.obj");
  EXPECT_EQ(mesh.position, glm::vec3(18.0F, 56.0F, 20.0F));
  EXPECT_FALSE(mesh.fit.has_value());
  EXPECT_EQ(scenario.world.obstacles[0].place.line, 9);
  EXPECT_EQ(scenario.world.obstacles[0].place.column, 7);
  ASSERT_EQ(scenario.world.goals.size(), 1U);
  EXPECT_EQ(scenario.world.goals[0].name, "exit");
  EXPECT_EQ(scenario.world.goals[0].place.line, 11);
  ASSERT_EQ(scenario.hals.size(), 1U);
  EXPECT_EQ(scenario.hals[0].name, "sim");
  EXPECT_EQ(scenario.hals[0].sim.plant, PlantKind::kVelocityLag);
  EXPECT_FLOAT_EQ(scenario.hals[0].sim.time_constant, 0.1F);
  EXPECT_FLOAT_EQ(scenario.hals[0].sim.rate, 200.0F);
}

TEST_F(Example, SwarmIsWhatTheInterfaceSays) {
  const auto result = load_scenario(folder_ / "two_blocks.yaml");
  ASSERT_TRUE(result);
  ASSERT_EQ(result->swarms.size(), 1U);
  const SwarmSpec& swarm = result->swarms[0];
  EXPECT_EQ(swarm.name, "flies");
  EXPECT_EQ(swarm.count, 300);
  EXPECT_EQ(swarm.goal, "exit");
  EXPECT_EQ(swarm.model, Model::kField);
  ASSERT_EQ(swarm.noise.octaves.size(), 1U);
  EXPECT_FLOAT_EQ(swarm.noise.octaves[0].scale, 0.4F);
  EXPECT_FLOAT_EQ(swarm.noise.octaves[0].gain, 0.25F);
  EXPECT_FLOAT_EQ(swarm.limits.separation, 0.2F);
  EXPECT_FALSE(swarm.governor);
  EXPECT_EQ(swarm.robots, "sim");
  EXPECT_EQ(swarm.place.line, 13);
  EXPECT_EQ(swarm.start_place.line, 15);
  EXPECT_EQ(swarm.goal_place.line, 16);
  EXPECT_EQ(swarm.goal_place.column, 11);
}

TEST_F(Example, ExpectationsAndPlanners) {
  const auto result = load_scenario(folder_ / "two_blocks.yaml");
  ASSERT_TRUE(result);
  ASSERT_EQ(result->expect.size(), 3U);
  EXPECT_EQ(result->expect[0].quantity, Expectation::Quantity::kReached);
  EXPECT_EQ(result->expect[0].comparison, Expectation::Comparison::kGreaterEqual);
  EXPECT_EQ(result->expect[0].wanted, 0.99);
  EXPECT_EQ(result->expect[0].text, "reached flies at exit");
  EXPECT_EQ(result->expect[1].quantity, Expectation::Quantity::kMinSeparation);
  EXPECT_EQ(result->expect[2].quantity, Expectation::Quantity::kPenetrations);
  EXPECT_EQ(result->expect[2].comparison, Expectation::Comparison::kEqual);
  ASSERT_EQ(result->planners.size(), 2U);
  EXPECT_EQ(result->planners[1].name, "pso");
  EXPECT_FLOAT_EQ(result->planners[1].rate, 10.0F);
  EXPECT_FLOAT_EQ(result->decision_rate(), 50.0F);  // the other one's
  EXPECT_FALSE(result->planners[0].latency.has_value());
  EXPECT_EQ(result->control.realtime, RealtimePolicy::kIgnore);
  EXPECT_THAT(test::all_text(result->warnings), testing::HasSubstr("planner 'pso' is not available yet"));
}

// The struct's own defaults are what code that makes scenarios by hand gets; the table's are what files get.
TEST(Defaults, OfTheTableAreThoseOfTheStructs) {
  const auto result = test::load_text(test::kSmallest);
  ASSERT_TRUE(result) << test::all_text(result.error());
  const SwarmSpec& got = result->swarms[0];
  const SwarmSpec want;
  EXPECT_EQ(result->name, "scenario");
  EXPECT_EQ(result->seed, Scenario{}.seed);
  EXPECT_EQ(result->duration, Scenario{}.duration);
  EXPECT_EQ(result->world.cell, WorldSpec{}.cell);
  EXPECT_EQ(result->control.rate, ControlSpec{}.rate);
  EXPECT_EQ(result->record.rate, RecordSpec{}.rate);
  EXPECT_EQ(got.noise.kind, want.noise.kind);
  EXPECT_EQ(got.noise.hash, want.noise.hash);
  EXPECT_EQ(got.noise.octaves[0].scale, want.noise.octaves[0].scale);
  EXPECT_EQ(got.noise.octaves[0].gain, want.noise.octaves[0].gain);
  EXPECT_EQ(got.cost.length_weight, want.cost.length_weight);
  EXPECT_EQ(got.cost.repulsion_weight, want.cost.repulsion_weight);
  EXPECT_EQ(got.cruise_speed, want.cruise_speed);
  EXPECT_EQ(got.limits.speed, want.limits.speed);
  EXPECT_EQ(got.limits.acceleration, want.limits.acceleration);
  EXPECT_EQ(got.limits.separation, want.limits.separation);
  EXPECT_EQ(got.radius, want.radius);
  EXPECT_EQ(got.mde_sweeps, want.mde_sweeps);
  EXPECT_EQ(got.governor, want.governor);
  EXPECT_EQ(got.robots, "sim");
  const SimHalSpec& sim = result->hals[0].sim;
  EXPECT_EQ(sim.plant, SimHalSpec{}.plant);
  EXPECT_EQ(sim.time_constant, SimHalSpec{}.time_constant);
  EXPECT_EQ(sim.rate, SimHalSpec{}.rate);
  EXPECT_EQ(sim.freeze_time, SimHalSpec{}.freeze_time);
  EXPECT_TRUE(result->warnings.empty());
}

}  // namespace
}  // namespace mayfly
