#include "controller/flight/world.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Error> refused(const Scenario& scenario) {
  auto world = build_world(scenario, 1, {});
  return world ? std::vector<Error>{} : std::move(world.error());
}

TEST(World, HasAFieldForEverything) {
  const Scenario scenario = walled_hall(1);
  const World world = world_of(scenario);
  const std::size_t cells = 12 * 20 * 12;
  EXPECT_EQ(world.grid.size(), cells);
  EXPECT_THAT(world.distance.distance, SizeIs(cells));
  EXPECT_THAT(world.walls, SizeIs(cells));
  ASSERT_THAT(world.costs, SizeIs(1));
  EXPECT_THAT(world.costs[0]->guide, SizeIs(4 * cells));
  EXPECT_THAT(world.warnings, IsEmpty());
  EXPECT_LT(world.solid.signed_distance({2, 8, 6}), 0.0F);
  EXPECT_GT(world.solid.signed_distance({6, 8, 6}), 0.0F);
  ASSERT_THAT(world.goals, SizeIs(1));
  EXPECT_TRUE(world.goals[0].contains({6, 15, 6}));
  EXPECT_FALSE(world.goals[0].contains({6, 11, 6}));
}

TEST(World, IsTheSameFromTheCache) {
  Scenario scenario = walled_hall(1);
  scenario.world.cell = 0.8F;  // nobody else's: the cache is this process's
  const World computed = world_of(scenario);
  const World kept = world_of(scenario);
  EXPECT_FALSE(computed.preprocessing.distance_cached);
  EXPECT_FALSE(computed.preprocessing.cost_cached);
  EXPECT_TRUE(kept.preprocessing.distance_cached);
  EXPECT_TRUE(kept.preprocessing.cost_cached);
  EXPECT_EQ(computed.distance.distance, kept.distance.distance);
  EXPECT_EQ(computed.walls, kept.walls);
  EXPECT_EQ(computed.costs[0]->guide, kept.costs[0]->guide);
  EXPECT_EQ(computed.costs[0]->kind, kept.costs[0]->kind);
  EXPECT_EQ(computed.costs[0]->blocked, kept.costs[0]->blocked);
}

TEST(World, IsComputedAnewWhereTheScenarioChanged) {
  Scenario scenario = walled_hall(1);
  scenario.world.cell = 0.9F;
  static_cast<void>(world_of(scenario));
  scenario.swarms[0].cost.repulsion_weight = 0.5F;
  const World other_weight = world_of(scenario);
  EXPECT_TRUE(other_weight.preprocessing.distance_cached);
  EXPECT_FALSE(other_weight.preprocessing.cost_cached);
  scenario.world.obstacles.pop_back();
  const World other_walls = world_of(scenario);
  EXPECT_FALSE(other_walls.preprocessing.distance_cached);
  EXPECT_FALSE(other_walls.preprocessing.cost_cached);
}

TEST(World, HasTheSameBitsOnTwoThreads) {
  Scenario scenario = walled_hall(1);
  const std::string folder = std::getenv("MAYFLY_CACHE_DIR");
  setenv("MAYFLY_CACHE_DIR", "/dev/null/nowhere", 1);
  const auto one = build_world(scenario, 1, {});
  const auto two = build_world(scenario, 2, {});
  setenv("MAYFLY_CACHE_DIR", folder.c_str(), 1);
  ASSERT_TRUE(one && two);
  EXPECT_FALSE(two->preprocessing.distance_cached) << "there is no cache";
  EXPECT_EQ(one->distance.distance, two->distance.distance);
  EXPECT_EQ(one->costs[0]->guide, two->costs[0]->guide);
}

TEST(World, SharesOneCostFieldAmongSwarmsThatFlyByTheSame) {
  Scenario scenario = hall(1);
  scenario.swarms.assign(6, scenario.swarms[0]);
  scenario.swarms[1].cost.length_weight = 0.7F;
  scenario.swarms[2].cost.repulsion_weight = 0.7F;
  scenario.swarms[3].radius = 0.7F;
  scenario.swarms[4].cost.influence = 1.0F;
  scenario.swarms[5].cruise_speed = 0.5F;  // no matter to the costs
  const World world = world_of(scenario);
  ASSERT_THAT(world.costs, SizeIs(6));
  EXPECT_EQ(world.costs[0].get(), world.costs[5].get());
  for (std::size_t other = 1; other < 5; ++other) {
    EXPECT_NE(world.costs[0].get(), world.costs[other].get()) << other;
  }
}

TEST(World, KeepsTheCostFieldsOfTwoGoalsApart) {
  Scenario scenario = hall(1);
  scenario.world.goals.push_back({"other", box({2, 6, 2}, {4, 8, 4}), {}});
  scenario.swarms.push_back(scenario.swarms[0]);
  scenario.swarms[1].goal = "other";
  const World world = world_of(scenario);
  EXPECT_NE(world.costs[0].get(), world.costs[1].get());
  EXPECT_LT(world.costs[0]->cost_at({6, 15, 6}), 0.0F);
  EXPECT_GT(world.costs[1]->cost_at({6, 15, 6}), 5.0F);
}

TEST(World, WarnsOfCellsThatCannotReachAGoal) {
  const World world = world_of(walled_hall(1, false));
  ASSERT_THAT(world.warnings, SizeIs(1));
  // 7 layers below the wall, of which none is nearer than half a cell.
  EXPECT_THAT(world.warnings[0].message, HasSubstr("1 008 free cells cannot reach goal 'exit'"));
  ASSERT_TRUE(world.warnings[0].place);
  EXPECT_EQ(world.warnings[0].place->line, 8);
}

TEST(World, WarnsOnceOfAGoalThatTwoSwarmsShare) {
  Scenario scenario = walled_hall(1, false);
  scenario.swarms.push_back(scenario.swarms[0]);
  EXPECT_THAT(world_of(scenario).warnings, SizeIs(1));
}

TEST(World, RefusesAGoalInsideAnObstacle) {
  Scenario scenario = hall(1);
  scenario.world.obstacles = {{box({1, 11, 1}, {11, 19, 11}), {}}};
  const auto errors = refused(scenario);
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("goal 'exit'"));
  EXPECT_THAT(errors[0].message, HasSubstr("inside obstacles"));
  ASSERT_TRUE(errors[0].place);
  EXPECT_EQ(errors[0].place->line, 8);
}

TEST(World, RefusesAnOpenMeshAndNamesItsLine) {
  Scenario scenario = hall(1);
  fields::MeshShape mesh;
  mesh.file = MAYFLY_SOURCE_DIR "/tests/bad_input/meshes/open_box.obj";
  scenario.world.obstacles = {{mesh, {"hall.yaml", 5, 5}}};
  const auto errors = refused(scenario);
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("open mesh"));
  ASSERT_TRUE(errors[0].place);
  EXPECT_EQ(errors[0].place->line, 5);
}

TEST(World, TellsOfBadObstaclesAndBadGoalsAtOnce) {
  Scenario scenario = hall(1);
  fields::MeshShape missing;
  missing.file = "/nowhere/at/all.obj";
  scenario.world.obstacles = {{missing, {"hall.yaml", 5, 5}}};
  scenario.world.goals[0].shape = missing;
  EXPECT_THAT(refused(scenario), SizeIs(2));
}

TEST(World, RefusesAGoalOutsideTheWorld) {
  Scenario scenario = hall(1);
  scenario.world.goals[0].shape = box({2, 112, 2}, {10, 118, 10});
  const auto errors = refused(scenario);
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("outside the world"));
}

TEST(World, RefusesMoreCellsThanCanBeAfforded) {
  Scenario scenario = hall(1);
  scenario.world.cell = 0.001F;
  EXPECT_THAT(refused(scenario), SizeIs(1));
}

}  // namespace
}  // namespace mayfly::test
