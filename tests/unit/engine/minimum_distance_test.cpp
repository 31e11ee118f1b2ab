// Minimum distance enforcement against whole sweeps over all pairs in double precision.
#include <gtest/gtest.h>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::scattered;
using test::SmallWorld;

constexpr TickTime kTick{0, 0.0, 0.01F};

struct Vec {
  double x, y, z;
};

// model.md §4: half of each overlap, along the line, all agents at once; every sweep looks at every pair.
std::vector<Vec> swept(std::vector<Vec> at, double distance, int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<Vec> before = at;
    for (std::size_t a = 0; a < at.size(); ++a) {
      for (std::size_t b = 0; b < at.size(); ++b) {
        const Vec line{before[a].x - before[b].x, before[a].y - before[b].y, before[a].z - before[b].z};
        const double length = std::sqrt(line.x * line.x + line.y * line.y + line.z * line.z);
        if (a != b && length < distance) {
          const double share = 0.5 * (distance - length) / length;
          at[a] = {at[a].x + share * line.x, at[a].y + share * line.y, at[a].z + share * line.z};
        }
      }
    }
  }
  return at;
}

Columns tick(Engine& engine, const Columns& at) {
  Columns out(at.x.size());
  engine.compute(at.positions(), kTick, out.velocities());
  return out;
}

class Sweeps : public testing::TestWithParam<int> {};

TEST_P(Sweeps, MoveTheSameAgentsAsFarAsWholeSweepsDo) {
  constexpr std::size_t kAgents = 400;
  Columns at = scattered(kAgents, 3);
  for (float& x : at.x) {
    x -= 8;  // away from the ball, where no wall stands in the way
  }
  SmallWorld world(kAgents, 0.3F, false);
  SmallWorld apart(kAgents, 0.0F, false);
  for (SwarmModel& swarm : world.swarms) {
    swarm.mde_sweeps = GetParam();
  }
  const auto engine = make_native_engine(2);
  ASSERT_TRUE(engine->prepare(apart.swarms, kAgents));
  const Columns free = tick(*engine, at);
  ASSERT_TRUE(engine->prepare(world.swarms, kAgents));
  const Columns parted = tick(*engine, at);
  std::vector<Vec> ahead;
  for (std::size_t a = 0; a < kAgents; ++a) {
    ahead.push_back({at.x[a] + 0.01 * free.x[a], at.y[a] + 0.01 * free.y[a], at.z[a] + 0.01 * free.z[a]});
  }
  const double tolerance = 2e-6 * (1 + GetParam() * GetParam());  // crowds magnify what rounding begins
  ahead = swept(ahead, 0.3, GetParam());
  for (std::size_t a = 0; a < kAgents; ++a) {
    EXPECT_NEAR(at.x[a] + 0.01 * parted.x[a], ahead[a].x, tolerance) << a;
    EXPECT_NEAR(at.y[a] + 0.01 * parted.y[a], ahead[a].y, tolerance) << a;
    EXPECT_NEAR(at.z[a] + 0.01 * parted.z[a], ahead[a].z, tolerance) << a;
  }
}
INSTANTIATE_TEST_SUITE_P(Numbers, Sweeps, testing::Values(1, 2, 3, 6));

// The order that is kept from tick to tick is for speed alone.
TEST(MinimumDistance, DoesNotDependOnTheTicksBefore) {
  constexpr std::size_t kAgents = 3000;
  const SmallWorld world(kAgents, 0.3F);
  const Columns at = scattered(kAgents, 8);
  const Columns elsewhere = scattered(kAgents, 5, 4);
  const auto engine = make_native_engine(2);
  ASSERT_TRUE(engine->prepare(world.swarms, kAgents));
  const Columns first = tick(*engine, at);
  EXPECT_EQ(tick(*engine, at), first);
  tick(*engine, elsewhere);
  EXPECT_EQ(tick(*engine, at), first);
}

}  // namespace
}  // namespace mayfly
