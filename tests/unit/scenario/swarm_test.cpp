// What the loader makes of swarms, beyond the checks of single keys.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "controller/scenario/packing.hpp"
#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

using test::changed;
using test::errors_of;
using testing::HasSubstr;

SwarmSpec swarm_of(const std::string& text) {
  const auto result = test::load_text(text);
  EXPECT_TRUE(result) << (result ? "" : test::all_text(result.error()));
  return result ? result->swarms.at(0) : SwarmSpec{};
}

std::string with_key(const std::string& key) {
  return changed("goal: exit\nhal", "goal: exit\n    " + key + "\nhal");
}

TEST(Preset, GivesDefaultsThatTheSwarmOverrides) {
  const SwarmSpec plain = swarm_of(with_key("preset: wang14/aggregation"));
  EXPECT_EQ(plain.cruise_speed, 2.5F);
  EXPECT_EQ(plain.noise.octaves[0].scale, 2.0F);
  EXPECT_EQ(plain.limits.speed, 4.0F);
  const SwarmSpec own =
      swarm_of(with_key("preset: wang14/aggregation\n    cruise_speed: 1\n    noise: {gain: 3}"));
  EXPECT_EQ(own.cruise_speed, 1.0F);
  EXPECT_EQ(own.noise.octaves[0].scale, 2.0F);
  EXPECT_EQ(own.noise.octaves[0].gain, 3.0F);
}

TEST(Preset, OwnOctavesReplaceItsScaleAndGain) {
  const SwarmSpec swarm = swarm_of(
      with_key("preset: wang14/locusts\n    noise: {octaves: [{scale: 1, gain: 2}, {scale: 3, gain: 4}]}"));
  ASSERT_EQ(swarm.noise.octaves.size(), 2U);
  EXPECT_EQ(swarm.noise.octaves[1].gain, 4.0F);
}

TEST(Preset, EveryBuiltInOneFlies) {
  for (const char* name : {"two_blocks", "chasing", "aggregation", "phototaxis", "locusts"}) {
    const SwarmSpec swarm = swarm_of(with_key(std::string("preset: wang14/") + name));
    EXPECT_LE(swarm.cruise_speed, swarm.limits.speed) << name;
  }
}

TEST(Cost, PresetsAreTheTwoPrintedForms) {
  const SwarmSpec eq4 = swarm_of(with_key("cost: {preset: wang14_eq4}"));
  EXPECT_EQ(eq4.cost.length_weight, 0.6F);
  EXPECT_EQ(eq4.cost.repulsion_weight, 0.4F);
  const std::string text = with_key("cost: {preset: wang14_eq7}");
  EXPECT_EQ(swarm_of(text).cost.length_weight, 1.0F);
  EXPECT_EQ(swarm_of(text).cost.repulsion_weight, 4.0F);
  std::string fine = text;
  fine.insert(fine.find("  goals"), "  cell: 0.5\n");
  EXPECT_EQ(swarm_of(fine).cost.length_weight, 0.5F);
  EXPECT_EQ(swarm_of(with_key("cost: {preset: wang14_eq7, repulsion_weight: 1}")).cost.repulsion_weight,
            1.0F);
}

TEST(Flags, AreWrittenAsPeopleWriteThem) {
  for (const char* off : {"off", "false", "no", "Off", "FALSE"}) {
    EXPECT_FALSE(swarm_of(with_key(std::string("governor: ") + off)).governor) << off;
  }
  for (const char* on : {"on", "true", "yes"}) {
    EXPECT_TRUE(swarm_of(with_key(std::string("governor: ") + on)).governor) << on;
  }
}

// A crystal of spheres of diameter s whose centres fill a box of side L has about √2 (L/s)³ of them: more
// than any count that may start.
TEST(Packing, BoundIsBetweenWhatCanBePutDownAndACrystal) {
  const double side = 10.0;
  const double separation = 0.5;
  const double volume = grown_box_volume(side, side, side, separation);
  const double crystal = std::numbers::sqrt2 * std::pow((side + separation) / separation, 3.0);
  const double cubic =
      std::pow(std::floor(side / separation) + 1.0, 3.0);  // centres on a simple cubic lattice
  const double most = count_that_fits(separation, volume, kRandomClosePacking);
  EXPECT_LT(most, crystal);
  EXPECT_GT(most, cubic);
  EXPECT_NEAR(packed_share(most, separation, volume), kRandomClosePacking, 1e-3);
  EXPECT_EQ(count_that_fits(1000.0, grown_sphere_volume(0.001, 1000.0), 0.64), 1.0);
}

TEST(Packing, RefusesOneAgentMoreThanFits) {
  // Ball of radius 2, separation 0.2: ball of 2.1 against balls of 0.1, times 0.64.
  const int most = static_cast<int>(0.64 * std::pow(2.1 / 0.1, 3.0));
  EXPECT_EQ(swarm_of(changed("count: 10", "count: " + std::to_string(most))).count, most);
  EXPECT_THAT(
      errors_of(changed("count: 10", "count: " + std::to_string(most + 1))),
      AllOf(HasSubstr("does not fit its start region"),
            HasSubstr("at most " + std::to_string(most) + " agents"), HasSubstr("scenario.yaml:9:12")));
}

TEST(Packing, RegionThatIsSuggestedHasRoom) {
  const std::string text = errors_of(changed("count: 10", "count: 20000"));
  const std::string words = "a region ";
  ASSERT_THAT(text, HasSubstr(words));
  const double factor = std::stod(text.substr(text.find(words) + words.size()));
  std::string larger = changed("count: 10", "count: 20000");
  larger.replace(larger.find("radius: 2"), 9, "radius: " + std::to_string(2.0 * factor));
  EXPECT_EQ(swarm_of(larger).count, 20000);
}

TEST(Packing, DenseStartIsAWarning) {
  const auto result = test::load_text(changed("count: 10", "count: 4000"));
  ASSERT_TRUE(result);
  EXPECT_THAT(test::all_text(result->warnings), HasSubstr("places are hard to find"));
}

TEST(Warnings, ObstacleNarrowerThanACell) {
  const auto warnings_with = [](const std::string& obstacle) {
    const auto result = test::load_text(changed("  goals:\n", "  obstacles: [" + obstacle + "]\n  goals:\n"));
    return result ? test::all_text(result->warnings) : test::all_text(result.error());
  };
  const std::string narrow = "0.98 m across may not be seen between samples 1 m apart";
  EXPECT_THAT(warnings_with("{sphere: {center: [5, 5, 5], radius: 0.49}}"), HasSubstr(narrow));
  EXPECT_THAT(warnings_with("{cylinder: {from: [5, 5, 0], to: [5, 5, 5], radius: 0.49}}"), HasSubstr(narrow));
  EXPECT_THAT(warnings_with("{box: {min: [5, 5, 5], max: [9, 5.98, 9]}}"), HasSubstr(narrow));
  EXPECT_EQ(warnings_with("{sphere: {center: [5, 5, 5], radius: 0.5}}"), "");
  EXPECT_EQ(warnings_with("{cylinder: {from: [5, 5, 0], to: [5, 5, 5], radius: 0.5}}"), "");
  EXPECT_EQ(warnings_with("{box: {min: [5, 5, 5], max: [9, 6, 9]}}"), "");
}

TEST(Warnings, SeparationBelowTwoRadii) {
  const auto result =
      test::load_text(with_key("radius: 0.15\n    governor: off\n    limits: {separation: 0.2}"));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->warnings.size(), 1U);
  EXPECT_THAT(to_string(result->warnings[0]), HasSubstr("less than two radii"));
  EXPECT_TRUE(test::load_text(with_key("radius: 0.1\n    limits: {separation: 0.2}"))->warnings.empty());
}

TEST(Separation, HasRoomForTubesWhereNobodySays) {
  EXPECT_FLOAT_EQ(swarm_of(with_key("radius: 0.15\n    limits: {tube: 0.05}")).limits.separation, 0.4F);
  EXPECT_FLOAT_EQ(swarm_of(with_key("radius: 0.15\n    limits: {separation: 0.3}")).limits.separation, 0.3F);
}

TEST(Limits, OfTheGovernorHaveHarmlessDefaults) {
  const LimitsSpec limits = swarm_of(with_key("limits: {acceleration: 7}")).limits;
  EXPECT_EQ(limits.braking, 7.0F);
  EXPECT_EQ(limits.tube, 0.0F);
  EXPECT_EQ(limits.latency, 0.0F);
  EXPECT_EQ(limits.watchdog, 0.0F);
  EXPECT_EQ(limits.downwash, 1.0F);
}

TEST(Separation, IsAtLeastTwoRadiiWhereNobodySays) {
  EXPECT_FLOAT_EQ(swarm_of(with_key("radius: 0.05")).limits.separation, 0.2F);
  EXPECT_FLOAT_EQ(swarm_of(with_key("radius: 0.15")).limits.separation, 0.3F);
  EXPECT_FLOAT_EQ(
      swarm_of(with_key("radius: 0.15\n    governor: off\n    limits: {separation: 0.1}")).limits.separation,
      0.1F);
}

TEST(Hals, SwarmMustSayWhichOfTwo) {
  EXPECT_THAT(errors_of(changed("  sim: {kind: sim}", "  a: {kind: sim}\n  b: {kind: sim}")),
              HasSubstr("does not say whose robots it flies"));
}

TEST(Hals, PlantRateFollowsControl) {
  const std::string text = changed("hal:", "control: {rate: 60}\nhal:");
  EXPECT_EQ(test::load_text(text)->hals[0].sim.rate, 240.0F);
  const auto odd = test::load_text(changed("{kind: sim}", "{kind: sim, rate: 250}"));
  ASSERT_TRUE(odd);
  EXPECT_THAT(test::all_text(odd->warnings), HasSubstr("no multiple of control.rate"));
}

TEST(Hals, ATubeBelowTheNoiseIsWarnedOf) {
  const auto warnings_with = [](const std::string& swarm, const std::string& hal) {
    std::string text = changed("{kind: sim}", "{kind: sim, " + hal + "}");
    text.replace(text.find("count: 10"), 9, "count: 10\n    " + swarm);
    const auto result = test::load_text(text);
    return result ? test::all_text(result->warnings) : test::all_text(result.error());
  };
  EXPECT_THAT(warnings_with("radius: 0.1", "pose_noise: 0.01"),
              HasSubstr("limits.tube is 0 m, but poses are noisy by 0.01 m: nothing is promised of the "
                        "difference; wanted >= 5 · pose_noise = 0.05 m"));
  EXPECT_THAT(warnings_with("limits: {tube: 0.049}", "pose_noise: 0.01"), HasSubstr("leave it by chance"));
  EXPECT_EQ(warnings_with("limits: {tube: 0.05}", "pose_noise: 0.01"), "");
  EXPECT_EQ(warnings_with("governor: off", "pose_noise: 0.01"), "");
  EXPECT_EQ(warnings_with("radius: 0.1", "pose_noise: 0"), "");
}

TEST(Agents, OfAllSwarmsTogetherAreCapped) {
  std::string text = changed("radius: 2", "radius: 3.9");
  text.replace(text.find("count: 10"), 9, "count: 1500000\n    limits: {separation: 0}");
  text.insert(text.find("hal:"),
              "  - {name: more, count: 600000, goal: exit, limits: {separation: 0}, start: {sphere: {center: "
              "[10, 5, 10], "
              "radius: 1}}}\n");
  EXPECT_THAT(errors_of(text),
              AllOf(HasSubstr("too many agents together"), HasSubstr("2100000"), HasSubstr("2000000")));
}

}  // namespace
}  // namespace mayfly
