#include "controller/flight/placement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::vector<glm::vec3> placed(const Scenario& scenario) {
  const World world = world_of(scenario);
  auto places = place_agents(scenario, world);
  if (!places) {
    ADD_FAILURE() << all_text(places.error());
    return {};
  }
  return std::move(*places);
}

std::vector<Error> refused(const Scenario& scenario) {
  const World world = world_of(scenario);
  auto places = place_agents(scenario, world);
  return places ? std::vector<Error>{} : std::move(places.error());
}

// 400 balls of half a metre: chance alone would break their distance over and over.
TEST(Placement, KeepsTheSeparationInsideABox) {
  Scenario scenario = hall(400);
  scenario.swarms[0].limits.separation = 0.5F;
  const auto places = placed(scenario);
  ASSERT_THAT(places, SizeIs(400));
  const Box start{{2, 1, 2}, {10, 5, 10}};
  for (const glm::vec3 p : places) {
    EXPECT_TRUE(start.contains(p));
  }
  EXPECT_GE(smallest_distance(places), 0.5F - 1e-6F);
}

TEST(Placement, KeepsTheSeparationInsideASphere) {
  Scenario scenario = hall(100);
  scenario.swarms[0].limits.separation = 0.4F;
  const glm::vec3 center{6, 4, 6};
  scenario.swarms[0].start = fields::SphereShape{center, 2.0F};
  const auto places = placed(scenario);
  ASSERT_THAT(places, SizeIs(100));
  for (const glm::vec3 p : places) {
    EXPECT_LE(glm::distance(p, center), 2.0F + 1e-5F);
  }
  EXPECT_GE(smallest_distance(places), 0.4F - 1e-6F);
}

TEST(Placement, FillsItsRegionToTheCorners) {
  const auto places = placed(hall(300));
  glm::vec3 low{1e9F};
  glm::vec3 high{-1e9F};
  for (const glm::vec3 p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_LT(glm::distance(low, {2, 1, 2}), 0.5F);
  EXPECT_LT(glm::distance(high, {10, 5, 10}), 0.5F);
}

TEST(Placement, StaysOutOfObstaclesByTheBodysRadius) {
  Scenario scenario = hall(200);
  scenario.swarms[0].radius = 0.3F;
  const glm::vec3 center{6, 3, 6};
  scenario.world.obstacles = {{fields::SphereShape{center, 1.5F}, {}}};
  const auto places = placed(scenario);
  ASSERT_THAT(places, SizeIs(200));
  float nearest = 1e9F;
  for (const glm::vec3 p : places) {
    nearest = std::min(nearest, glm::distance(p, center));
  }
  EXPECT_GE(nearest, 1.8F - 1e-4F);
  EXPECT_LT(nearest, 2.3F) << "nobody dares near it: the test shows nothing";
}

TEST(Placement, KeepsHalfTheSumOfTwoSwarmsSeparations) {
  Scenario scenario = hall(60);
  scenario.swarms.push_back(scenario.swarms[0]);
  scenario.swarms[0].limits.separation = 0.2F;
  scenario.swarms[1].limits.separation = 1.0F;
  scenario.swarms[1].name = "bees";
  const auto places = placed(scenario);
  ASSERT_THAT(places, SizeIs(120));
  float across = 1e9F;
  for (std::size_t a = 0; a < 60; ++a) {
    for (std::size_t b = 60; b < 120; ++b) {
      across = std::min(across, glm::distance(places[a], places[b]));
    }
  }
  EXPECT_GE(across, 0.6F - 1e-6F);
  EXPECT_GE(smallest_distance({places.begin() + 60, places.end()}), 1.0F - 1e-6F);
}

TEST(Placement, FollowsFromTheSeed) {
  Scenario scenario = hall(20);
  const auto once = placed(scenario);
  EXPECT_EQ(once, placed(scenario));
  scenario.seed = 6;
  EXPECT_NE(once, placed(scenario));
  scenario.seed = 5 + (std::uint64_t{1} << 32U);
  EXPECT_NE(once, placed(scenario)) << "the seed's upper half counts";
}

TEST(Placement, DoesNotDependOnHowManyFollow) {
  const auto few = placed(hall(5));
  auto many = placed(hall(50));
  many.resize(5);
  EXPECT_EQ(few, many);
}

TEST(Placement, OfNobodyIsEmpty) {
  EXPECT_THAT(placed(hall(0)), SizeIs(0));
}

TEST(Placement, RefusesAStartInsideAnObstacle) {
  Scenario scenario = hall(10);
  scenario.world.obstacles = {{box({1, 0, 1}, {11, 6, 11}), {}}};
  const auto errors = refused(scenario);
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("'flies': no place for agent 1 of 10"));
  EXPECT_THAT(errors[0].message, HasSubstr("inside obstacles"));
  ASSERT_TRUE(errors[0].place);
  EXPECT_EQ(errors[0].place->line, 12);
}

TEST(Placement, RefusesAStartWithoutAWayToTheGoal) {
  const auto errors = refused(walled_hall(10, false));
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("no free path leads from the region to the goal"));
  ASSERT_TRUE(errors[0].place);
  EXPECT_EQ(errors[0].place->line, 12);
}

TEST(Placement, RefusesMoreAgentsThanFit) {
  Scenario scenario = hall(100);
  scenario.swarms[0].limits.separation = 2.0F;
  const auto errors = refused(scenario);
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_THAT(errors[0].message, HasSubstr("the agents do not fit at their separation"));
  EXPECT_THAT(errors[0].message, ::testing::ContainsRegex("agent [0-9]+ of 100"));
}

TEST(Placement, TellsOfEverySwarmThatHasNoPlace) {
  Scenario scenario = walled_hall(10, false);
  scenario.swarms.push_back(scenario.swarms[0]);
  scenario.swarms[1].name = "bees";
  EXPECT_THAT(refused(scenario), SizeIs(2));
}

}  // namespace
}  // namespace mayfly::test
