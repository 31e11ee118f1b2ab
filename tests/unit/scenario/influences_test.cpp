// Paths, brushes, lamps and what a swarm is held to: what a good file becomes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

using test::changed;
using testing::HasSubstr;

Scenario loaded(const std::string& text) {
  const auto result = test::load_text(text);
  EXPECT_TRUE(result) << test::all_text(result.error());
  return result ? *result : Scenario{};
}

TEST(Influences, AreOffByDefault) {
  const Scenario scenario = loaded(test::kSmallest);
  EXPECT_TRUE(scenario.world.brushes.empty());
  EXPECT_TRUE(scenario.lamps.empty());
  EXPECT_FALSE(scenario.world.coarse_cell);
  EXPECT_FALSE(scenario.world.goals.at(0).path);
  EXPECT_EQ(scenario.swarms.at(0).noise.drift, 0.0F);
  EXPECT_EQ(scenario.swarms.at(0).cost.density_weight, 0.0F);
  EXPECT_EQ(scenario.field_rate, 5.0F);
  EXPECT_TRUE(scenario.warnings.empty());
}

TEST(Paths, OfGoalsAndObstacles) {
  const Scenario scenario = loaded(changed(
      "  goals:\n    exit: {sphere: {center: [10, 18, 10], radius: 1}}",
      "  obstacles:\n"
      "    - {sphere: {center: [0, 0, 0], radius: 1}, path: {points: [[0, 0, 0], [0, 0, 50]], speed: 2}}\n"
      "  goals:\n"
      "    exit:\n"
      "      sphere: {center: [10, 18, 10], radius: 1}\n"
      "      path: {points: [[10, 18, 10], [1, 18, 10], [10, 18, 10]], speed: 0.5, loop: on}"));
  const auto& path = scenario.world.goals.at(0).path;
  ASSERT_TRUE(path);
  ASSERT_EQ(path->points.size(), 3U);
  EXPECT_EQ(path->points[1], glm::vec3(1.0F, 18.0F, 10.0F));
  EXPECT_EQ(path->speed, 0.5F);
  EXPECT_TRUE(path->loop);
  EXPECT_EQ(path->place.line, 9);
  ASSERT_TRUE(scenario.world.obstacles.at(0).path);  // it may leave the world
  EXPECT_FALSE(scenario.world.obstacles[0].path->loop);
}

TEST(Brushes, AreReadWithTheirDefaults) {
  const Scenario scenario = loaded(
      changed("swarms:\n",
              "  brushes:\n"
              "    - attract: {center: [1, 2, 3], radius: 4, strength: 0.5}\n"
              "    - {repel: {center: [5, 5, 5], radius: 2, strength: 3, term: potential}, swarm: flies}\n"
              "swarms:\n"));
  ASSERT_EQ(scenario.world.brushes.size(), 2U);
  const BrushSpec& first = scenario.world.brushes[0];
  EXPECT_EQ(first.effect, BrushSpec::Effect::kAttract);
  EXPECT_EQ(first.term, BrushSpec::Term::kCost);
  EXPECT_EQ(first.center, glm::vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(first.radius, 4.0F);
  EXPECT_EQ(first.strength, 0.5F);
  EXPECT_EQ(first.swarm, "");
  const BrushSpec& second = scenario.world.brushes[1];
  EXPECT_EQ(second.effect, BrushSpec::Effect::kRepel);
  EXPECT_EQ(second.term, BrushSpec::Term::kPotential);
  EXPECT_EQ(second.swarm, "flies");
  EXPECT_TRUE(scenario.warnings.empty());
}

TEST(Brushes, ThatDoLessThanTheySayAreWarnings) {
  const auto warned = [](const std::string& brush) {
    return test::all_text(loaded(changed("swarms:\n", "  brushes: [" + brush + "]\nswarms:\n")).warnings);
  };
  EXPECT_THAT(warned("attract: {center: [1, 2, 3], radius: 4, strength: 0.55}"),
              HasSubstr("takes away no more than 0.54"));
  EXPECT_THAT(warned("repel: {center: [1, 2, 3], radius: 0.5, strength: 1}"), HasSubstr("between cells"));
  EXPECT_EQ(warned("repel: {center: [1, 2, 3], radius: 4, strength: 100}"), "");
}

TEST(Lamps, AreReadAndMayBeWhatASwarmCircles) {
  const Scenario scenario =
      loaded(changed("hal:\n",
                     "stimuli:\n"
                     "  - lamp: {name: street, position: [1, 2, 3], reach: 9, speed: 0.5, probability: 0.1}\n"
                     "expect:\n"
                     "  - turns: {lamp: street, number: \">= 2\"}\n"
                     "  - turns: {around: [4, 5, 6], number: \"> 1\"}\n"
                     "hal:\n"));
  ASSERT_EQ(scenario.lamps.size(), 1U);
  EXPECT_EQ(scenario.lamps[0].name, "street");
  EXPECT_EQ(scenario.lamps[0].reach, 9.0F);
  EXPECT_EQ(scenario.lamps[0].speed, 0.5F);
  EXPECT_EQ(scenario.lamps[0].probability, 0.1F);
  ASSERT_EQ(scenario.expect.size(), 2U);
  EXPECT_EQ(scenario.expect[0].quantity, Expectation::Quantity::kTurns);
  EXPECT_EQ(scenario.expect[0].text, "turns flies around street");
  EXPECT_EQ(scenario.expect[0].around, glm::vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(scenario.expect[0].wanted, 2.0);
  EXPECT_EQ(scenario.expect[1].around, glm::vec3(4.0F, 5.0F, 6.0F));
}

TEST(Expectations, OfASwarmAsAWhole) {
  using Quantity = Expectation::Quantity;
  const Scenario scenario =
      loaded(changed("hal:\n",
                     "expect:\n"
                     "  - drift: {distance: \"<= 1\"}\n"
                     "  - goal_distance: {swarm: flies, goal: exit, distance: \"< 3\"}\n"
                     "  - spread: {swarm: flies, radius: \"<= 4\"}\n"
                     "  - field_age: \"<= 0.5\"\n"
                     "  - wall_clearance: \">= 0.1\"\n"
                     "hal:\n"));
  ASSERT_EQ(scenario.expect.size(), 5U);
  const std::vector<std::pair<Quantity, std::string>> wanted = {
      {Quantity::kCentreDrift, "drift flies"},
      {Quantity::kGoalDistance, "goal_distance flies at exit"},
      {Quantity::kSpread, "spread flies"},
      {Quantity::kFieldAge, "field_age"},
      {Quantity::kWallClearance, "wall_clearance"}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(scenario.expect[i].quantity, wanted[i].first);
    EXPECT_EQ(scenario.expect[i].text, wanted[i].second);
  }
  EXPECT_EQ(scenario.expect[4].wanted, 0.1);
}

TEST(Noise, HasFiveKindsAndDrifts) {
  const std::vector<std::pair<std::string, NoiseKind>> kinds = {{"curl", NoiseKind::kCurl},
                                                                {"none", NoiseKind::kNone},
                                                                {"perlin", NoiseKind::kPerlin},
                                                                {"white", NoiseKind::kWhite},
                                                                {"gaussian", NoiseKind::kGaussian}};
  for (const auto& [name, kind] : kinds) {
    const Scenario scenario =
        loaded(changed("goal: exit\n", "goal: exit\n    noise: {kind: " + name + ", drift: 0.3}\n"));
    EXPECT_EQ(scenario.swarms.at(0).noise.kind, kind) << name;
    EXPECT_EQ(scenario.swarms[0].noise.drift, 0.3F);
    EXPECT_EQ(scenario.warnings.size(), name == "white" || name == "gaussian" ? 1U : 0U) << name;
  }
}

TEST(Fields, RateDensityAndNesting) {
  const Scenario scenario = loaded(changed("hal:\n",
                                           "    cost: {density_weight: 0.2}\n"
                                           "planners: {fields: {rate: 20}}\n"
                                           "hal:\n"));
  EXPECT_EQ(scenario.field_rate, 20.0F);
  EXPECT_EQ(scenario.swarms.at(0).cost.density_weight, 0.2F);
  EXPECT_TRUE(scenario.planners.empty());
  const Scenario nested = loaded(changed("  goals:", "  cell: 0.1\n  coarse_cell: 0.8\n  goals:"));
  EXPECT_EQ(nested.world.coarse_cell, 0.8F);
}

TEST(Goals, AreResolvedOnce) {
  const Scenario scenario =
      loaded(changed("  goals:\n", "  goals:\n    far: {sphere: {center: [3, 3, 3], radius: 1}}\n"));
  EXPECT_EQ(scenario.swarms.at(0).goal_index, 1U);
}

}  // namespace
}  // namespace mayfly
