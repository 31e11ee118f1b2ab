#include "controller/flight/start_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/flight/placement.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;

std::string refused(const Scenario& scenario, const std::vector<glm::vec3>& places) {
  const World world = world_of(scenario);
  const auto ok = check_start(scenario, world, places);
  return ok ? "" : to_string(ok.error());
}

Scenario governed_hall(int agents) {
  Scenario scenario = hall(agents);
  scenario.swarms[0].governor = true;
  return scenario;
}

TEST(StartCheck, NamesThePairTheSwarmAndTheInequality) {
  const Scenario scenario = governed_hall(3);
  EXPECT_EQ(refused(scenario, {{4, 4, 4}, {6, 4, 4}, {4, 4.11F, 4}}), "");
  const std::string near = refused(scenario, {{4, 4, 4}, {6, 4, 4}, {4, 4.09F, 4}});
  EXPECT_THAT(near,
              HasSubstr("hall.yaml:12:7: flies_0 and flies_2 start too near to each other; found 0.0900 m"));
  EXPECT_THAT(near, HasSubstr("wanted >= two radii + two tubes + rounding = 0.10"));
}

TEST(StartCheck, NamesWhoSticksOutOfTheFence) {
  const Scenario scenario = governed_hall(2);
  EXPECT_EQ(refused(scenario, {{4, 4, 4}, {0.06F, 4, 4}}), "");
  EXPECT_THAT(refused(scenario, {{4, 4, 4}, {0.04F, 4, 4}}),
              HasSubstr("flies_1 starts where it cannot stop inside the fence; found 0.0400 m"));
}

TEST(StartCheck, NumbersAgentsByTheirSwarm) {
  Scenario scenario = governed_hall(1);
  scenario.swarms.push_back(scenario.swarms[0]);
  scenario.swarms[1].name = "others";
  scenario.swarms[1].start_place = {"hall.yaml", 20, 7};
  EXPECT_THAT(refused(scenario, {{4, 4, 4}, {0.04F, 4, 4}}), HasSubstr("hall.yaml:20:7: others_0 starts"));
}

TEST(StartCheck, WhoIsNotGovernedStartsAnywhere) {
  Scenario scenario = hall(2);
  scenario.swarms[0].governor = false;
  EXPECT_EQ(refused(scenario, {{4, 4, 4}, {4, 4, 4}}), "");
}

TEST(StartCheck, LimitsThatContradictTheFenceAreRefused) {
  Scenario scenario = governed_hall(1);
  scenario.swarms[0].limits.braking = 0.1F;
  EXPECT_THAT(refused(scenario, {{4, 4, 4}}),
              HasSubstr("hall.yaml:12:7: the fence is smaller than a stopping distance"));
}

// A separation of two radii leaves nothing for rounding: chance alone would break the start over and over.
TEST(StartCheck, WherePlacesAreTightTheyAreSafe) {
  Scenario scenario = governed_hall(400);
  scenario.swarms[0].radius = 0.25F;
  scenario.swarms[0].limits.separation = 0.5F;
  const World world = world_of(scenario);
  const auto places = place_agents(scenario, world);
  ASSERT_TRUE(places);
  const auto ok = check_start(scenario, world, *places);
  EXPECT_TRUE(ok) << to_string(ok.error());
}

}  // namespace
}  // namespace mayfly::test
