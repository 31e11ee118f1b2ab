// Both engines against each other, and minimum distance against brute force.
#include "controller/engine/engine.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <limits>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::scattered;
using test::SmallWorld;

constexpr float kPeriod = 0.01F;
constexpr TickTime kTick{0, 0.0, kPeriod};

Columns fly_one_tick(Engine& engine, const SmallWorld& world, const Columns& at,
                     std::size_t* moved = nullptr) {
  const std::size_t agents = at.x.size();
  EXPECT_TRUE(engine.prepare(world.swarms, agents));
  Columns out(agents);
  const std::size_t count = engine.compute(at.positions(), kTick, out.velocities()).moved;
  EXPECT_EQ(engine.fault(), "");
  if (moved != nullptr) {
    *moved = count;
  }
  return out;
}

double least_distance_after(const Columns& at, const Columns& v) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < at.x.size(); ++a) {
    for (std::size_t b = a + 1; b < at.x.size(); ++b) {
      const double dx = at.x[a] + v.x[a] * kPeriod - at.x[b] - v.x[b] * kPeriod;
      const double dy = at.y[a] + v.y[a] * kPeriod - at.y[b] - v.y[b] * kPeriod;
      const double dz = at.z[a] + v.z[a] * kPeriod - at.z[b] - v.z[b] * kPeriod;
      least = std::min(least, std::sqrt(dx * dx + dy * dy + dz * dz));
    }
  }
  return least;
}

class EnginesOfSize : public testing::TestWithParam<std::size_t> {};

// Positions in and around walls, at every fill of the last lanes: the field model uses only + − × ÷ √ and
// integers.
TEST_P(EnginesOfSize, NativeAndOpenclGiveTheSameBits) {
  const std::size_t agents = GetParam();
  const SmallWorld world(agents, 0.3F);
  const Columns at = scattered(agents, 10);
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  std::size_t moved_native = 0, moved_opencl = 0;
  const Columns a = fly_one_tick(*make_native_engine(1), world, at, &moved_native);
  const Columns b = fly_one_tick(**opencl, world, at, &moved_opencl);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
  EXPECT_EQ(moved_native, moved_opencl);
}
INSTANTIATE_TEST_SUITE_P(Sizes, EnginesOfSize, testing::Values(1, 2, 7, 8, 9, 300, 5000));

// Turned about, the world must be flown as if it had been prepared that way, tables and rest places alike.
TEST(Engines, FlyByFieldsThatWereReplaced) {
  constexpr std::size_t kAgents = 300;
  const SmallWorld world(kAgents, 0.3F);
  SmallWorld other(kAgents, 0.3F);
  for (std::size_t cell = 0; cell < other.walls.size(); ++cell) {
    other.walls[cell] += 0.5F;
    std::swap(other.guide[4 * cell], other.guide[4 * cell + 2]);
    other.guide[4 * cell + 3] -= 11.0F;  // half of the agents are in the goal, where rest places count
  }
  const glm::vec3 offset(-3.0F, 1.0F, 2.5F);
  const Columns at = scattered(kAgents, 10);
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  const auto native = make_native_engine(1);
  for (Engine* engine : {native.get(), opencl->get()}) {
    const Columns before = fly_one_tick(*engine, world, at);
    for (std::size_t swarm = 0; swarm < 2; ++swarm) {
      engine->replace_fields(swarm, {other.walls, other.guide, offset, glm::vec3(0.0F)});
    }
    Columns out(kAgents);
    engine->compute(at.positions(), kTick, out.velocities());
    EXPECT_EQ(engine->fault(), "");
    EXPECT_NE(out, before);
    for (std::size_t a = 0; a < kAgents; ++a) {
      other.rest_x[a] = world.rest_x[a] + offset.x;
      other.rest_y[a] = world.rest_y[a] + offset.y;
      other.rest_z[a] = world.rest_z[a] + offset.z;
    }
    EXPECT_EQ(out, fly_one_tick(*engine, other, at)) << engine->name();
  }
}

// Whoever is in a goal that moves is carried along; at walls and bounds the guard may hold him back.
TEST(BothEngines, CarryAgentsWithTheirGoal) {
  constexpr std::size_t kAgents = 400;
  SmallWorld world(kAgents, 0.0F);
  for (std::size_t cell = 0; cell < world.walls.size(); ++cell) {
    world.guide[4 * cell + 3] -= 100.0F;  // everybody is deep in the goal
  }
  const glm::vec3 velocity(0.3F, -0.2F, 0.1F);
  const Columns at = scattered(kAgents, 11);
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  const auto native = make_native_engine(1);
  for (Engine* engine : {native.get(), opencl->get()}) {
    const Columns before = fly_one_tick(*engine, world, at);
    for (std::size_t swarm = 0; swarm < 2; ++swarm) {
      engine->replace_fields(swarm, {{}, {}, glm::vec3(0.0F), velocity});
    }
    Columns out(kAgents);
    engine->compute(at.positions(), kTick, out.velocities());
    std::size_t carried = 0;
    for (std::size_t a = 0; a < kAgents; ++a) {
      const glm::vec3 more(out.x[a] - before.x[a], out.y[a] - before.y[a], out.z[a] - before.z[a]);
      carried += glm::distance(more, velocity) < 1e-4F ? 1U : 0U;
    }
    EXPECT_GT(carried, kAgents / 2) << engine->name();
  }
}

TEST(NativeEngine, MovesNobodyWhoIsFarFromOthers) {
  const SmallWorld far(200, 0.01F);
  const SmallWorld none(200, 0.0F);
  const Columns at = scattered(200, 20);
  std::size_t moved = 99;
  const Columns with = fly_one_tick(*make_native_engine(1), far, at, &moved);
  EXPECT_EQ(moved, 0U);
  EXPECT_EQ(with, fly_one_tick(*make_native_engine(1), none, at));
}

TEST(NativeEngine, PartsPairsThatWouldBeTooNear) {
  // Pairs 0.05 m apart on a wide lattice: only pairs, so that one sweep does it.
  constexpr std::size_t kPairs = 100;
  SmallWorld world(2 * kPairs, 0.2F);
  Columns at(2 * kPairs);
  for (std::size_t p = 0; p < kPairs; ++p) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t a = p + side * kPairs;
      const std::size_t row = p / 10;
      at.x[a] = 1.0F + 2.2F * static_cast<float>(p % 10) + 0.05F * static_cast<float>(side);
      at.y[a] = 1.0F + 2.2F * static_cast<float>(row);
      at.z[a] = 2.0F;
    }
  }
  std::size_t moved = 0;
  const Columns v = fly_one_tick(*make_native_engine(1), world, at, &moved);
  EXPECT_EQ(moved, 2 * kPairs);
  EXPECT_GE(least_distance_after(at, v), 0.2 - 1e-5);
}

TEST(NativeEngine, SpreadsACrowdUntilNobodyIsTooNear) {
  const SmallWorld world(60, 0.2F, false);
  const Columns at = scattered(60, 1.6F);
  Columns spread(60);
  for (std::size_t a = 0; a < 60; ++a) {  // away from the ball, where no wall stands in the way
    spread.x[a] = at.x[a] - 8;
    spread.y[a] = at.y[a];
    spread.z[a] = at.z[a];
  }
  const Columns v = fly_one_tick(*make_native_engine(1), world, spread);
  EXPECT_GE(least_distance_after(spread, v), 0.98 * 0.2);
}

TEST(NativeEngine, PartsAgentsAtOnePoint) {
  for (const std::size_t agents : {2U, 3U, 12U}) {
    const SmallWorld world(agents, 0.2F, false);
    Columns at(agents);
    std::fill(at.x.begin(), at.x.end(), 3.0F);
    std::fill(at.y.begin(), at.y.end(), 3.0F);
    std::fill(at.z.begin(), at.z.end(), 3.0F);
    const Columns v = fly_one_tick(*make_native_engine(1), world, at);
    EXPECT_GT(least_distance_after(at, v), 0.15) << agents;
  }
}

TEST(NativeEngine, PushesNobodyThroughAWall) {
  // A crowd that touches the ball: pushed about, nobody may near it faster than the guard allows.
  const SmallWorld world(40, 0.3F);
  Columns at = scattered(40, 0.4F);
  for (float& x : at.x) {
    x -= 3.4F;
  }
  const Columns v = fly_one_tick(*make_native_engine(1), world, at);
  for (std::size_t a = 0; a < 40; ++a) {
    const double dx = at.x[a] - 12.0, dy = at.y[a] - 12.0, dz = at.z[a] - 12.0;
    const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double outward = (dx * v.x[a] + dy * v.y[a] + dz * v.z[a]) / r;
    const double clearance = r - 3.0 - 0.05;
    EXPECT_GE(outward, -5.0 * std::max(clearance, 0.0) - 0.35)
        << "0.35 m/s: the sampled ball is not quite round";
  }
}

TEST(NativeEngine, SurvivesPositionsThatAreNoNumbers) {
  const SmallWorld world(16, 0.2F);
  Columns at = scattered(16, 10);
  at.x[3] = std::numeric_limits<float>::quiet_NaN();
  at.y[5] = std::numeric_limits<float>::infinity();
  at.z[7] = -1e30F;
  const Columns v = fly_one_tick(*make_native_engine(1), world, at);
  for (const std::size_t a : {0U, 1U, 2U, 4U, 6U, 8U}) {
    EXPECT_TRUE(std::isfinite(v.x[a]) && std::isfinite(v.y[a]) && std::isfinite(v.z[a])) << a;
  }
}

TEST(NativeEngine, FliesNobody) {
  const SmallWorld world(0, 0.2F);
  EXPECT_TRUE(fly_one_tick(*make_native_engine(2), world, Columns(0)).x.empty());
}

}  // namespace
}  // namespace mayfly
