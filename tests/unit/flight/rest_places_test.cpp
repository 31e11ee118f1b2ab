#include "controller/flight/rest_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::SizeIs;

std::vector<glm::vec3> rested(const Scenario& scenario) {
  return rest_places(scenario, world_of(scenario), 0);
}

TEST(RestPlaces, LieInTheGoalAndApart) {
  Scenario scenario = hall(300);
  scenario.swarms[0].limits.separation = 0.4F;
  const auto places = rested(scenario);
  ASSERT_THAT(places, SizeIs(300));
  const Box goal{{2, 12, 2}, {10, 18, 10}};
  for (const glm::vec3 p : places) {
    EXPECT_TRUE(goal.contains(p));
  }
  EXPECT_GE(smallest_distance(places), 0.4F - 1e-6F);
}

TEST(RestPlaces, FillTheGoal) {
  const auto places = rested(hall(300));
  glm::vec3 low{1e9F};
  glm::vec3 high{-1e9F};
  for (const glm::vec3 p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_LT(glm::distance(low, {2, 12, 2}), 0.7F);
  EXPECT_LT(glm::distance(high, {10, 18, 10}), 0.7F);
}

TEST(RestPlaces, AreFreeOfObstaclesByTheBodysRadius) {
  Scenario scenario = hall(200);
  scenario.swarms[0].radius = 0.3F;
  const glm::vec3 center{6, 15, 6};
  scenario.world.obstacles = {{fields::SphereShape{center, 1.6F}, {}}};
  for (const glm::vec3 p : rested(scenario)) {
    EXPECT_GE(glm::distance(p, center), 1.9F - 1e-4F);
  }
}

TEST(RestPlaces, FollowFromTheSeed) {
  Scenario scenario = hall(20);
  const auto once = rested(scenario);
  EXPECT_EQ(once, rested(scenario));
  scenario.seed = 6;
  EXPECT_NE(once, rested(scenario));
}

TEST(RestPlaces, OfASwarmAreNotThoseOfAnother) {
  Scenario scenario = hall(20);
  scenario.swarms.push_back(scenario.swarms[0]);
  const World world = world_of(scenario);
  EXPECT_NE(rest_places(scenario, world, 0), rest_places(scenario, world, 1));
}

TEST(RestPlaces, OfAGoalSmallerThanACellAreAllInTheCellThatHoldsIt) {
  Scenario scenario = hall(20);
  scenario.world.goals[0].shape = fields::SphereShape{{6.1F, 15.2F, 6.3F}, 0.1F};
  const auto places = rested(scenario);
  ASSERT_THAT(places, SizeIs(20));
  for (const glm::vec3 p : places) {
    EXPECT_EQ(p, glm::vec3(6.5F, 15.5F, 6.5F));
  }
}

TEST(RestPlaces, OfMoreAgentsThanFitStillLieInTheGoal) {
  Scenario scenario = hall(5000);
  scenario.swarms[0].limits.separation = 3.0F;
  const auto places = rested(scenario);
  ASSERT_THAT(places, SizeIs(5000));
  const Box goal{{2, 12, 2}, {10, 18, 10}};
  for (const glm::vec3 p : places) {
    EXPECT_TRUE(goal.contains(p));
  }
}

TEST(RestPlaces, OfNobodyAreEmpty) {
  EXPECT_THAT(rested(hall(0)), SizeIs(0));
}

}  // namespace
}  // namespace mayfly::test
