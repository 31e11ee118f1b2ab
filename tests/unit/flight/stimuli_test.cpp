// What agents of the force model flee and seek, from the scenario to the engine.
#include "controller/flight/stimuli.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/flight/motor_models.hpp"
#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Notes what moves.
class Listener final : public Engine {
 public:
  std::string_view name() const noexcept override { return "listener"; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override { return {}; }
  TickCounts compute(const AgentColumns&, const TickTime&, const VelocityColumns&) noexcept override {
    return {};
  }
  void move_stimuli(std::size_t swarm, std::span<const glm::vec3> places) noexcept override {
    moved.push_back(swarm);
    last.assign(places.begin(), places.end());
  }
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}

  std::vector<std::size_t> moved;
  std::vector<glm::vec3> last;
};

StimulusSpec predator(glm::vec3 from, glm::vec3 to) {
  StimulusSpec spec;
  spec.kind = StimulusSpec::Kind::kPredator;
  spec.name = "hawk";
  spec.position = from;
  spec.reach = 3.0F;
  spec.weight = 20.0F;
  spec.path = PathSpec{{from, to}, 2.0F, false, {}};
  return spec;
}

Scenario flown_by_forces() {
  Scenario scenario = hall(5);
  scenario.swarms[0].model = Model::kForces;
  return scenario;
}

TEST(Stimuli, ReachTheKernelLampsFirst) {
  Scenario scenario = flown_by_forces();
  scenario.stimuli = {predator({1, 2, 3}, {5, 2, 3})};
  LampSpec lamp;
  lamp.position = {6, 6, 6};
  lamp.weight = 1.5F;
  lamp.reach = 5.0F;
  scenario.lamps = {lamp};
  kernels::MfForces forces{};
  add_stimuli(scenario, scenario.swarms[0], forces);
  ASSERT_EQ(forces.stimuli, 2);
  EXPECT_EQ(forces.stimulus[0].kind, MF_STIMULUS_PREY);
  EXPECT_EQ(forces.stimulus[0].weight, 1.5F);
  EXPECT_EQ(forces.stimulus[1].kind, MF_STIMULUS_PREDATOR);
  EXPECT_EQ(forces.stimulus[1].x, 1.0F);
  EXPECT_EQ(forces.stimulus[1].reach, 3.0F);
}

TEST(Stimuli, AreFeltByWhomTheyAreMeantFor) {
  Scenario scenario = flown_by_forces();
  scenario.stimuli = {predator({1, 2, 3}, {5, 2, 3})};
  scenario.stimuli[0].swarm = "others";
  kernels::MfForces forces{};
  add_stimuli(scenario, scenario.swarms[0], forces);
  EXPECT_EQ(forces.stimuli, 0);
  scenario.stimuli[0].swarm = "flies";
  scenario.swarms[0].model = Model::kBoids;
  add_stimuli(scenario, scenario.swarms[0], forces);
  EXPECT_EQ(forces.stimuli, 0);
}

TEST(Stimuli, MoveAlongTheirPathAndThoseThatStandStayWhereTheyAre) {
  Scenario scenario = flown_by_forces();
  StimulusSpec crop;
  crop.position = {9, 9, 9};
  scenario.stimuli = {crop, predator({1, 2, 3}, {5, 2, 3})};
  MovingStimuli stimuli(scenario);
  Listener engine;
  stimuli.move(0.0, engine);
  EXPECT_THAT(engine.last, ElementsAre(glm::vec3(9, 9, 9), glm::vec3(1, 2, 3)));
  stimuli.move(1.0, engine);
  EXPECT_THAT(engine.last, ElementsAre(glm::vec3(9, 9, 9), glm::vec3(3, 2, 3)));
  stimuli.move(100.0, engine);
  EXPECT_THAT(engine.last, ElementsAre(glm::vec3(9, 9, 9), glm::vec3(5, 2, 3)));
  EXPECT_THAT(engine.moved, ElementsAre(0U, 0U, 0U));
}

TEST(Stimuli, NobodyIsToldOfWhatDoesNotMove) {
  Scenario scenario = flown_by_forces();
  scenario.stimuli = {StimulusSpec{}};
  MovingStimuli stimuli(scenario);
  Listener engine;
  stimuli.move(1.0, engine);
  EXPECT_THAT(engine.moved, IsEmpty());
}

TEST(Motors, EachModelHasItsOwn) {
  const std::pair<Model, Motor> kMotors[] = {{Model::kField, Motor::kField},
                                             {Model::kOrca, Motor::kField},
                                             {Model::kForces, Motor::kForces},
                                             {Model::kBoids, Motor::kBoids},
                                             {Model::kBrownian, Motor::kBrownian}};
  for (const auto& [model, motor] : kMotors) {
    Scenario scenario = hall(1);
    scenario.swarms[0].model = model;
    SwarmModel swarm;
    set_motor(scenario, scenario.swarms[0], swarm);
    EXPECT_EQ(swarm.motor, motor);
  }
}

// q/γ − c/d = 4 m²/s², unless the limit is lower.
TEST(Motors, ABrownianParticleMostlyFliesAtWhatItsDepotGives) {
  SwarmSpec swarm;
  swarm.model = Model::kBrownian;
  swarm.limits.speed = 10.0F;
  swarm.brownian.friction = 1.0F;
  swarm.brownian.intake = 5.0F;
  swarm.brownian.dissipation = 2.0F;
  swarm.brownian.conversion = 2.0F;
  EXPECT_FLOAT_EQ(typical_speed(swarm), 2.0F);
  swarm.limits.speed = 0.5F;
  EXPECT_FLOAT_EQ(typical_speed(swarm), 0.5F);
}

TEST(Motors, BodiesThatAvoidAreAsLargeAsTheirSeparationAsks) {
  SwarmSpec swarm;
  swarm.radius = 0.05F;
  swarm.limits.separation = 0.4F;
  EXPECT_FLOAT_EQ(kernel_avoidance(swarm, 0.1F, 3.0F).radius, 0.25F);
  swarm.limits.separation = 0.0F;
  EXPECT_FLOAT_EQ(kernel_avoidance(swarm, 0.0F, 3.0F).radius, 0.05F);
}

}  // namespace
}  // namespace mayfly::test
