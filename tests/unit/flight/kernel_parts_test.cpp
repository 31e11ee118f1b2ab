#include "controller/flight/kernel_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/flight/swarm_models.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(KernelNoise, HasTheKindAndTheSpeedOfTheScenarios) {
  NoiseSpec spec;
  spec.octaves = {{0.4F, 0.25F}, {0.2F, 0.05F}};
  spec.drift = 0.3F;
  for (const auto& [said, kind] :
       {std::pair{NoiseKind::kCurl, MF_NOISE_CURL}, std::pair{NoiseKind::kPerlin, MF_NOISE_PERLIN},
        std::pair{NoiseKind::kWhite, MF_NOISE_WHITE}, std::pair{NoiseKind::kGaussian, MF_NOISE_GAUSSIAN}}) {
    spec.kind = said;
    const kernels::MfNoise noise = kernel_noise(spec, 9);
    EXPECT_EQ(noise.kind, kind);
    EXPECT_EQ(noise.drift, 0.3F);
    EXPECT_EQ(noise.seed, 9U);
    EXPECT_NEAR(noise.rms_speed, 1.718 * std::hypot(0.25 / 0.4, 0.05 / 0.2), 1e-5);
  }
}

TEST(SwarmModels, HaveNoiseWhereItIsNotOff) {
  Scenario scenario = hall(1);
  scenario.swarms[0].noise.kind = NoiseKind::kGaussian;
  const kernels::MfField field = make_swarm_models(scenario, world_of(scenario)).swarms.at(0).field;
  EXPECT_EQ(field.has_noise, 1);
  EXPECT_EQ(field.noise.kind, MF_NOISE_GAUSSIAN);
  EXPECT_EQ(field.pulls, 0);
}

LampSpec lamp(const std::string& swarm) {
  LampSpec spec;
  spec.name = "street";
  spec.position = {1, 2, 3};
  spec.reach = 20;
  spec.speed = 0.5F;
  spec.probability = 0.25F;
  spec.swarm = swarm;
  return spec;
}

BrushSpec brush(BrushSpec::Effect effect, BrushSpec::Term term) {
  BrushSpec spec;
  spec.effect = effect;
  spec.term = term;
  spec.center = {4, 5, 6};
  spec.radius = 3;
  spec.strength = 0.75F;
  return spec;
}

TEST(Pulls, AreThoseThatAreMeantForTheSwarm) {
  Scenario scenario = hall(2);
  scenario.lamps = {lamp("others"), lamp("")};
  scenario.world.brushes = {brush(BrushSpec::Effect::kAttract, BrushSpec::Term::kCost),
                            brush(BrushSpec::Effect::kRepel, BrushSpec::Term::kPotential)};
  kernels::MfField field{};
  add_pulls(scenario, scenario.swarms[0], field);
  ASSERT_EQ(field.pulls, 2);
  EXPECT_EQ(field.pull[0].kind, MF_PULL_LAMP);
  EXPECT_EQ(field.pull[0].y, 2);
  EXPECT_EQ(field.pull[0].reach, 20);
  EXPECT_EQ(field.pull[0].speed, 0.5F);
  EXPECT_EQ(field.pull[0].probability, 0.25F);
  EXPECT_EQ(field.pull[1].kind, MF_PULL_BRUSH);
  EXPECT_EQ(field.pull[1].x, 4);
  EXPECT_EQ(field.pull[1].reach, 3);
  EXPECT_EQ(field.pull[1].speed, -0.75F) << "it pushes";
  scenario.swarms[0].name = "others";
  add_pulls(scenario, scenario.swarms[0], field);
  EXPECT_EQ(field.pulls, 3);
}

TEST(Pulls, AreRefusedWhereThereAreMoreThanASwarmFollows) {
  Scenario scenario = hall(2);
  scenario.lamps.assign(MF_MAX_PULLS, lamp(""));
  EXPECT_THAT(excess_pulls(scenario), SizeIs(0));
  scenario.lamps.push_back(lamp("others"));
  EXPECT_THAT(excess_pulls(scenario), SizeIs(0));
  scenario.lamps.push_back(lamp("flies"));
  scenario.swarms[0].place = {"hall.yaml", 9, 5};
  const auto world = build_world(scenario, 1, {});
  ASSERT_FALSE(world);
  EXPECT_THAT(
      all_text(world.error()),
      HasSubstr("hall.yaml:9:5: swarm 'flies' has too many lamps and potential brushes; found 17; wanted "
                "at most 16"));
}

}  // namespace
}  // namespace mayfly::test
