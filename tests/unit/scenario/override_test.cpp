#include "controller/scenario/override.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

using testing::HasSubstr;

ScenarioResult load_with(const std::vector<std::string>& texts, std::string_view scenario = test::kSmallest) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) {
    overrides.push_back(parse_override(text).value());
  }
  return test::load_text(scenario, overrides);
}

std::string problems_with(const std::vector<std::string>& texts) {
  const auto result = load_with(texts);
  return result ? "it loads" : test::all_text(result.error());
}

TEST(Override, SetsByNameAndByNumber) {
  const auto result = load_with(
      {"swarms.flies.count=7", "seed=99", "world.bounds.max.2=30", "swarms.0.noise.scale=2.5", "name=other"});
  ASSERT_TRUE(result) << test::all_text(result.error());
  EXPECT_EQ(result->swarms[0].count, 7);
  EXPECT_EQ(result->seed, 99U);
  EXPECT_EQ(result->world.bounds.max.z, 30.0F);
  EXPECT_EQ(result->swarms[0].noise.octaves[0].scale, 2.5F);
  EXPECT_EQ(result->name, "other");
}

TEST(Override, TakesWholeValuesAndNewNames) {
  const auto result = load_with({"world.obstacles=[{sphere: {center: [10, 10, 10], radius: 2}}]",
                                 "world.goals.top={box: {min: [1, 1, 1], max: [2, 2, 2]}}",
                                 "swarms.flies.goal=top", "swarms.flies.preset=wang14/locusts"});
  ASSERT_TRUE(result) << test::all_text(result.error());
  EXPECT_EQ(result->world.obstacles.size(), 1U);
  EXPECT_EQ(result->swarms[0].goal, "top");
  EXPECT_EQ(result->swarms[0].cruise_speed, 8.0F);
}

TEST(Override, LaterOnesWin) {
  const auto result = load_with({"seed=1", "seed=2"});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->seed, 2U);
}

TEST(Override, ErrorsNameTheOverrideAndSuggest) {
  EXPECT_THAT(problems_with({"swarms.flies.cuont=10"}),
              AllOf(HasSubstr("--set swarms.flies.cuont=10: unknown key 'cuont'"),
                    HasSubstr("did you mean 'count'?")));
  EXPECT_THAT(problems_with({"swarms.flys.count=10"}),
              AllOf(HasSubstr("has no element"), HasSubstr("'flies'?")));
  EXPECT_THAT(problems_with({"swarms.1.count=10"}), HasSubstr("a number from 0 to 0, or flies"));
  EXPECT_THAT(problems_with({"swarms.-1.count=10"}), HasSubstr("has no element"));
  EXPECT_THAT(problems_with({"hal.sin.rate=400"}),
              AllOf(HasSubstr("'hal' has no 'sin'"), HasSubstr("'sim'?")));
  EXPECT_THAT(problems_with({"world.cell.x=1"}), HasSubstr("nothing under 'world.cell'"));
  EXPECT_THAT(problems_with({"world.obstacles.0.mesh=a"}), HasSubstr("it is empty"));
  EXPECT_THAT(problems_with({"seed.=1"}), HasSubstr("nothing under 'seed'"));
  EXPECT_THAT(problems_with({"..=1"}), HasSubstr("unknown key ''"));
}

TEST(Override, ValuesGoThroughTheSameChecks) {
  EXPECT_THAT(
      problems_with({"swarms.flies.count=-3"}),
      AllOf(HasSubstr("--set swarms.flies.count=-3: 'count' is out of range"), Not(HasSubstr(":1:"))));
  EXPECT_THAT(problems_with({"world.cell=2 m"}), HasSubstr("found '2 m'"));
  EXPECT_THAT(problems_with({"seed="}), HasSubstr("found nothing"));
  EXPECT_THAT(problems_with({"seed=[1"}), HasSubstr("--set seed=[1: this '[' is never closed"));
  EXPECT_THAT(problems_with({"seed=&a 1"}), HasSubstr("anchors"));
  EXPECT_THAT(problems_with({"swarms.flies.robots=sam"}),
              HasSubstr("--set swarms.flies.robots=sam: there is no HAL"));
}

TEST(Override, OneThatFailsLeavesNothingBehind) {
  const std::string text = problems_with({"control.rte=5", "swarms.flies.limits.sped=5"});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
}

TEST(Override, NeedsAPathAndAnEqualsSign) {
  EXPECT_FALSE(parse_override("swarms.flies.count"));
  EXPECT_FALSE(parse_override("=3"));
  const auto good = parse_override("a.b=c=d");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->path, "a.b");
  EXPECT_EQ(good->value, "c=d");
}

}  // namespace
}  // namespace mayfly
