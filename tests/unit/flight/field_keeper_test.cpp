// The thread that solves fields beside the control loop. Run under ThreadSanitizer, too: the engine here
// reads all that it was given at every tick, as a real one does.
#include "controller/flight/field_keeper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/flight/worlds.hpp"

namespace mayfly::test {
namespace {

class Reader final : public Engine {
 public:
  std::string_view name() const noexcept override { return "reader"; }
  Result<void> prepare(std::span<const SwarmModel> /*swarms*/, std::size_t /*agents*/) override { return {}; }
  TickCounts compute(const AgentColumns& /*at*/, const TickTime& /*tick*/,
                     const VelocityColumns& /*out*/) noexcept override {
    sum = 0.0;
    for (const std::span<const float> table : {walls, guide}) {
      for (const float value : table) {
        sum += static_cast<double>(value);
      }
    }
    return {};
  }
  void move_stimuli(std::size_t /*swarm*/, std::span<const glm::vec3> /*places*/) noexcept override {}
  void replace_fields(std::size_t /*swarm*/, const SwarmFields& fields) noexcept override {
    walls = fields.walls.empty() ? walls : fields.walls;
    guide = fields.guide.empty() ? guide : fields.guide;
    offset = fields.goal_offset;
    velocity = fields.goal_velocity;
  }

  std::span<const float> walls, guide;
  glm::vec3 offset{0.0F}, velocity{0.0F};
  double sum = 0.0;
};

// A goal and a ball that move, and crowds that count.
Scenario busy_hall(int agents) {
  Scenario scenario = hall(agents);
  scenario.world.goals[0].shape = fields::SphereShape{{4, 14, 6}, 3};
  scenario.world.goals[0].path = PathSpec{{{4, 14, 6}, {8, 14, 6}}, 1.0F, true, {}};
  scenario.world.obstacles = {{fields::SphereShape{{6, 8, 6}, 1.5F}, {}, {}}};
  scenario.world.obstacles[0].path = PathSpec{{{6, 8, 6}, {6, 8, 3}}, 0.5F, true, {}};
  scenario.swarms[0].cost.density_weight = 0.5F;
  return scenario;
}

std::vector<float> column(std::size_t agents, float first, float step) {
  std::vector<float> values(agents);
  for (std::size_t a = 0; a < agents; ++a) {
    values[a] = first + step * static_cast<float>(a);
  }
  return values;
}

struct Crowd {
  explicit Crowd(std::size_t agents)
      : x(column(agents, 3, 0.2F)), y(column(agents, 2, 0.1F)), z(column(agents, 6, -0.05F)) {}
  PositionColumns columns() const { return {x, y, z}; }
  std::vector<float> x, y, z;
};

struct Flown {
  std::vector<float> guides;  // of every set that was taken over, one after the other
  std::vector<double> sums;   // one a tick
  FieldsSummary summary;
};

Flown fly(const Scenario& scenario, FieldKeeper::Settings settings, int ticks) {
  const World world = world_of(scenario);
  const Crowd crowd(static_cast<std::size_t>(scenario.swarms[0].count));
  Motion motion(scenario);
  Reader engine;
  Flown flown;
  auto keeper = FieldKeeper::start(scenario, *world.solver, settings);
  EXPECT_TRUE(keeper);
  for (int tick = 0; tick < ticks; ++tick) {
    const double time_s = 0.01 * tick;
    const float* before = engine.guide.data();
    motion.set_time(time_s);
    (*keeper)->tick(time_s, crowd.columns(), motion, engine);
    engine.compute({}, {}, {});
    flown.sums.push_back(engine.sum);
    if (engine.guide.data() != before) {
      flown.guides.insert(flown.guides.end(), engine.guide.begin(), engine.guide.end());
    }
    EXPECT_EQ(engine.offset, scenario.world.goals[0].path->displacement(time_s));
    EXPECT_EQ(engine.velocity, scenario.world.goals[0].path->velocity(time_s));
  }
  flown.summary = (*keeper)->summary();
  return flown;
}

TEST(FieldKeeper, OnAVirtualClockGivesTheSameSetsAtTheSameTicksOnAnyNumberOfThreads) {
  const Scenario scenario = busy_hall(12);
  const Flown one = fly(scenario, {.waits = true, .threads = 1}, 101);
  EXPECT_EQ(one.summary.updates, 5U);
  EXPECT_EQ(one.guides.size(), 5 * 4 * world_of(scenario).grid.size());
  const Flown two = fly(scenario, {.waits = true, .threads = 2}, 101);
  EXPECT_TRUE(two.guides == one.guides);
  EXPECT_TRUE(two.sums == one.sums);
}

// Ticks as fast as they come: most planner's ticks then find no set, and fly on by the one they have.
TEST(FieldKeeper, OnTheRealClockTakesNothingOverThatIsStillWritten) {
  const Scenario scenario = busy_hall(12);
  const Flown flown = fly(scenario, {.waits = false, .threads = 1}, 4000);
  EXPECT_LE(flown.summary.updates, 199U);
  ASSERT_TRUE(flown.summary.age_s);
  EXPECT_GE(flown.summary.age_s->max, 0.39);
}

TEST(FieldKeeper, EndsInTheMiddleOfASolveOrBeforeTheFirst) {
  const Scenario scenario = busy_hall(3);
  for (int ticks = 0; ticks < 24; ticks += 3) {
    EXPECT_EQ(fly(scenario, {.waits = false, .threads = 1}, ticks).sums.size(),
              static_cast<std::size_t>(ticks));
  }
}

// Whoever has lost its position is in no crowd.
TEST(FieldSolver, LeavesOutPositionsThatAreNoNumbers) {
  const Scenario scenario = busy_hall(12);
  const World world = world_of(scenario);
  FieldInputs inputs{.time_s = 0.0, .from_s = 0.2, .until_s = 0.4};
  const Crowd crowd(12);
  const auto solved = [&](std::size_t lost, glm::vec3 at) {
    FieldSet set = world.solver->make_set();
    inputs.x = crowd.x;
    inputs.y = crowd.y;
    inputs.z = crowd.z;
    for (std::size_t a = 0; a < lost; ++a) {
      inputs.x[a] = at.x;
      inputs.y[a] = at.y;
      inputs.z[a] = at.z;
    }
    EXPECT_TRUE(world.solver->solve(inputs, 1, set));
    return set;
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const glm::vec3 away(-1e6F);
  const std::vector<float> all_known = solved(0, away).costs[0].guide;
  for (const std::size_t lost : {1U, 12U}) {
    const FieldSet wanted = solved(lost, away);
    EXPECT_FALSE(wanted.costs[0].guide == all_known) << "crowds count at all";
    for (const glm::vec3 at : {glm::vec3(kNan), glm::vec3(3.0F, 2.0F, kNan), glm::vec3(kInfinity, 2, 6)}) {
      const FieldSet set = solved(lost, at);
      EXPECT_TRUE(set.costs[0].guide == wanted.costs[0].guide);
      EXPECT_TRUE(set.walls == wanted.walls);
      EXPECT_EQ(set.cut_off, wanted.cut_off);
    }
  }
}

}  // namespace
}  // namespace mayfly::test
