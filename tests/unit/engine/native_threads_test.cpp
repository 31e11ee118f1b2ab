// The native engine on several threads: the same bits as on one, and (under ThreadSanitizer) no race.
#include <gtest/gtest.h>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::scattered;
using test::SmallWorld;

// Ten ticks in which agents fly on, the second half by other fields.
std::vector<Columns> flown(const SmallWorld& world, const SmallWorld& later, Columns at, int threads) {
  constexpr float kPeriod = 0.01F;
  const std::size_t agents = at.x.size();
  const auto engine = make_native_engine(threads);
  EXPECT_TRUE(engine->prepare(world.swarms, agents));
  std::vector<Columns> all;
  for (std::uint64_t tick = 0; tick < 10; ++tick) {
    if (tick == 5) {
      for (std::size_t swarm = 0; swarm < 2; ++swarm) {
        engine->replace_fields(swarm, {later.walls, later.guide, glm::vec3(1.0F), glm::vec3(0.1F)});
      }
    }
    Columns out(agents);
    engine->compute(at.positions(), {tick, kPeriod * static_cast<double>(tick), kPeriod}, out.velocities());
    for (std::size_t a = 0; a < agents; ++a) {
      at.x[a] += kPeriod * out.x[a];
      at.y[a] += kPeriod * out.y[a];
      at.z[a] += kPeriod * out.z[a];
    }
    all.push_back(std::move(out));
  }
  return all;
}

TEST(NativeEngine, GivesTheSameBitsOnAnyNumberOfThreads) {
  constexpr std::size_t kAgents = 6000;
  const SmallWorld world(kAgents, 0.2F);
  SmallWorld later(kAgents, 0.2F);
  for (std::size_t cell = 0; cell < later.walls.size(); ++cell) {
    std::swap(later.guide[4 * cell], later.guide[4 * cell + 2]);
  }
  const Columns at = scattered(kAgents, 11);
  const std::vector<Columns> one = flown(world, later, at, 1);
  for (const int threads : {2, 3, 5}) {
    EXPECT_TRUE(flown(world, later, at, threads) == one) << threads;
  }
}

}  // namespace
}  // namespace mayfly
