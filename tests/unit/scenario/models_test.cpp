// What a scenario says of models beside the field model, of stimuli, and of who is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

// A swarm of the force model and no goals, with `swarm` and `more` put in.
std::string insects(const std::string& swarm, const std::string& more = "",
                    const std::string& model = "forces") {
  return R"(mayfly: 1
world:
  bounds: {min: [0, 0, 0], max: [20, 20, 20]}
swarms:
  - name: midges
    count: 30
    start: {box: {min: [4, 5, 5], max: [14, 15, 17]}}
    model: )" +
         model + "\n" + swarm + "hal:\n  sim: {kind: sim}\n" + more;
}

Scenario loaded(const std::string& text) {
  auto scenario = test::load_text(text);
  EXPECT_TRUE(scenario) << (scenario ? "" : test::all_text(scenario.error()));
  return scenario ? *scenario : Scenario{};
}

SwarmSpec swarm_of_text(const std::string& text) {
  const Scenario scenario = loaded(text);
  return scenario.swarms.empty() ? SwarmSpec{} : scenario.swarms[0];
}

TEST(Models, ZonesFollowEachOtherByTheirWidths) {
  const SwarmSpec swarm = swarm_of_text(insects(
      "    forces: {friction: 13, repulsion: {weight: 3, radius: 0.45}, alignment: {weight: 5, width: 1.5}, "
      "attraction: {weight: 7, width: 5}, far_error: 0.01}\n"));
  EXPECT_EQ(swarm.model, Model::kForces);
  EXPECT_FLOAT_EQ(swarm.forces.friction, 13.0F);
  EXPECT_FLOAT_EQ(swarm.forces.repulsion_weight, 3.0F);
  EXPECT_FLOAT_EQ(swarm.forces.repulsion_radius, 0.45F);
  EXPECT_FLOAT_EQ(swarm.forces.alignment_weight, 5.0F);
  EXPECT_FLOAT_EQ(swarm.forces.alignment_radius, 1.95F);
  EXPECT_FLOAT_EQ(swarm.forces.attraction_weight, 7.0F);
  EXPECT_FLOAT_EQ(swarm.forces.attraction_radius, 6.95F);
  EXPECT_FLOAT_EQ(swarm.forces.far_error, 0.01F);
}

TEST(Models, WhatIsLeftOutIsTheMidges) {
  const ForcesSpec forces = swarm_of_text(insects("")).forces;
  EXPECT_FLOAT_EQ(forces.friction, 11.16F);
  EXPECT_FLOAT_EQ(forces.repulsion_radius, 0.17F);
  EXPECT_FLOAT_EQ(forces.alignment_radius, 0.17F);
  EXPECT_FLOAT_EQ(forces.attraction_radius, 5.29F);
  EXPECT_FLOAT_EQ(forces.far_error, 0.0F);
}

// At 15 °C Ren16 Eq. 1 gives 13.8664 agents where it gives 18.5894 at 25 °C: each has 1.1026 times the way.
TEST(Models, TemperatureScalesRadiiAndNothingElse) {
  const ForcesSpec forces = swarm_of_text(insects("    temperature: 15\n")).forces;
  const double factor = std::cbrt(18.5894 / 13.8664);
  EXPECT_NEAR(forces.repulsion_radius, 0.17 * factor, 1e-4);
  EXPECT_NEAR(forces.attraction_radius, 5.29 * factor, 1e-3);
  EXPECT_FLOAT_EQ(forces.repulsion_weight, 5.61F);
  const BoidsSpec boids = swarm_of_text(insects("    temperature: 15\n", "", "boids")).boids;
  EXPECT_NEAR(boids.cohesion_radius, 1.5 * factor, 1e-3);
  EXPECT_FLOAT_EQ(swarm_of_text(insects("    temperature: 25\n")).forces.repulsion_radius, 0.17F);
}

TEST(Models, OnlyForcesAndOrcaAvoidCollisionsUnlessTold) {
  EXPECT_TRUE(swarm_of_text(insects("")).avoidance.on);
  EXPECT_FALSE(swarm_of_text(insects("    avoidance: {kind: none}\n")).avoidance.on);
  EXPECT_FALSE(swarm_of_text(insects("", "", "boids")).avoidance.on);
  EXPECT_FALSE(swarm_of_text(insects("", "", "brownian")).avoidance.on);
  EXPECT_TRUE(swarm_of_text(insects("    avoidance: {kind: orca}\n", "", "boids")).avoidance.on);
  EXPECT_FALSE(loaded(test::kSmallest).swarms.at(0).avoidance.on);
  EXPECT_TRUE(loaded(test::changed("goal: exit", "goal: exit\n    model: orca")).swarms.at(0).avoidance.on);
}

TEST(Models, RangeIsWhereTwoCouldMeetWithinTheHorizon) {
  const SwarmSpec swarm =
      swarm_of_text(insects("    limits: {speed: 2, separation: 0.1}\n    governor: off\n    radius: 0.2\n   "
                            " avoidance: {horizon: 3}\n"));
  EXPECT_FLOAT_EQ(swarm.avoidance.range, 0.4F + 2.0F * 2.0F * 3.0F);
  EXPECT_FLOAT_EQ(swarm_of_text(insects("    avoidance: {range: 5}\n")).avoidance.range, 5.0F);
}

TEST(Models, AvoidanceIsStrictIfTold) {
  EXPECT_FALSE(swarm_of_text(insects("")).avoidance.strict);
  EXPECT_TRUE(swarm_of_text(insects("    avoidance: {strict: on}\n")).avoidance.strict);
}

TEST(Models, OrcaFliesWithoutNoise) {
  const Scenario scenario = loaded(test::changed("goal: exit", "goal: exit\n    model: orca"));
  EXPECT_EQ(scenario.swarms.at(0).noise.kind, NoiseKind::kNone);
  EXPECT_TRUE(scenario.swarms.at(0).is_guided());
}

TEST(Models, ParticlesArePulledToTheMiddleOfTheirStart) {
  EXPECT_EQ(swarm_of_text(insects("", "", "brownian")).brownian.center, glm::vec3(9.0F, 10.0F, 11.0F));
  EXPECT_EQ(swarm_of_text(insects("    brownian: {center: [1, 2, 3]}\n", "", "brownian")).brownian.center,
            glm::vec3(1.0F, 2.0F, 3.0F));
}

TEST(Models, OnlyTheseNeedNoGoal) {
  const SwarmSpec swarm = swarm_of_text(insects(""));
  EXPECT_EQ(swarm.goal, "");
  EXPECT_FALSE(swarm.is_guided());
  EXPECT_THAT(test::errors_of(test::changed("    goal: exit\n", "")), HasSubstr("the key 'goal' is missing"));
}

TEST(Models, KeysOfAnotherModelAreWorthAWarning) {
  const Scenario scenario = loaded(test::changed("goal: exit", "goal: exit\n    forces: {friction: 2}"));
  ASSERT_THAT(scenario.warnings, SizeIs(1));
  EXPECT_THAT(scenario.warnings[0].message, HasSubstr("'forces' does nothing"));
}

TEST(Models, JoinAndLeaveAreAsWritten) {
  const SwarmSpec swarm = swarm_of_text(
      insects("    join: {first: 20, rate: 0.5}\n    leave: {after: 30, rate: 2, count: 10}\n"));
  ASSERT_TRUE(swarm.join && swarm.leave);
  EXPECT_EQ(swarm.join->first, 20);
  EXPECT_FLOAT_EQ(swarm.join->rate, 0.5F);
  EXPECT_FLOAT_EQ(swarm.leave->after, 30.0F);
  EXPECT_FLOAT_EQ(swarm.leave->rate, 2.0F);
  EXPECT_EQ(swarm.leave->count, 10);
  EXPECT_FALSE(swarm_of_text(insects("")).join);
}

TEST(Stimuli, EachKindIsAsWritten) {
  const Scenario scenario = loaded(insects("", R"(stimuli:
  - predator: {name: hawk, position: [1, 2, 3], reach: 8, weight: 20, path: {points: [[1, 2, 3], [5, 2, 3]], speed: 2}}
  - {food: {name: fruit, position: [4, 5, 6], reach: 3, weight: 2}, swarm: midges}
  - mate: {name: female, position: [7, 8, 9], reach: 2, weight: 10}
  - ahead: {distance: 2, turn: 90, reach: 10, weight: 5}
)"));
  ASSERT_THAT(scenario.stimuli, SizeIs(4));
  const StimulusSpec& hawk = scenario.stimuli[0];
  EXPECT_EQ(hawk.kind, StimulusSpec::Kind::kPredator);
  EXPECT_EQ(hawk.name, "hawk");
  EXPECT_FLOAT_EQ(hawk.reach, 8.0F);
  EXPECT_FLOAT_EQ(hawk.weight, 20.0F);
  EXPECT_EQ(hawk.position_at(0.0), glm::vec3(1.0F, 2.0F, 3.0F));
  EXPECT_EQ(hawk.position_at(1.0), glm::vec3(3.0F, 2.0F, 3.0F));
  EXPECT_EQ(hawk.position_at(60.0), glm::vec3(5.0F, 2.0F, 3.0F));
  EXPECT_EQ(scenario.stimuli[1].kind, StimulusSpec::Kind::kFood);
  EXPECT_EQ(scenario.stimuli[1].swarm, "midges");
  EXPECT_EQ(scenario.stimuli[1].position_at(7.0), glm::vec3(4.0F, 5.0F, 6.0F));
  EXPECT_EQ(scenario.stimuli[2].kind, StimulusSpec::Kind::kMate);
  EXPECT_EQ(scenario.stimuli[3].kind, StimulusSpec::Kind::kAhead);
  EXPECT_FLOAT_EQ(scenario.stimuli[3].distance, 2.0F);
  EXPECT_FLOAT_EQ(scenario.stimuli[3].turn, 1.5707964F);
}

TEST(Stimuli, LampsDrawTheForceModelByTheirWeight) {
  const Scenario scenario =
      loaded(insects("", "stimuli:\n  - lamp: {name: street, position: [9, 9, 9], reach: 5, weight: 2.5}\n"));
  ASSERT_THAT(scenario.lamps, SizeIs(1));
  EXPECT_FLOAT_EQ(scenario.lamps[0].weight, 2.5F);
}

TEST(Expectations, AboutInsectsNameTheirSwarmAndStimulus) {
  const Scenario scenario = loaded(insects("", R"(stimuli:
  - predator: {name: hawk, position: [1, 2, 3], reach: 8, weight: 20}
expect:
  - polarisation: {order: ">= 0.9"}
  - arrived: {stimulus: hawk, within: 1.5, at: 20, fraction: ">= 0.5"}
  - parting: {swarm: midges, stimulus: hawk, ratio: ">= 1.5"}
  - infeasible: "<= 0.01"
)"));
  ASSERT_THAT(scenario.expect, SizeIs(4));
  using Quantity = Expectation::Quantity;
  EXPECT_EQ(scenario.expect[0].quantity, Quantity::kPolarisation);
  EXPECT_EQ(scenario.expect[0].text, "polarisation midges");
  EXPECT_EQ(scenario.expect[1].quantity, Quantity::kArrived);
  EXPECT_EQ(scenario.expect[1].text, "arrived midges by hawk at 20 s");
  EXPECT_EQ(scenario.expect[1].stimulus, "hawk");
  EXPECT_FLOAT_EQ(scenario.expect[1].within, 1.5F);
  EXPECT_EQ(scenario.expect[1].at, 20.0);
  EXPECT_EQ(scenario.expect[2].quantity, Quantity::kParting);
  EXPECT_EQ(scenario.expect[2].text, "parting midges by hawk");
  EXPECT_EQ(scenario.expect[3].quantity, Quantity::kInfeasible);
}

}  // namespace
}  // namespace mayfly
