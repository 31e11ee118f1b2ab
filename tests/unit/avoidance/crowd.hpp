// Two swarms with avoidance in a small world, for comparing engines and threads bit by bit.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly::test {

// Two swarms about a ball, in a box whose bounds some of them touch; the first is small and strict, the
// second has other habits, or minds nobody.
struct Crowd {
  SmallWorld world;
  Columns at, velocity;

  explicit Crowd(std::size_t agents, bool second_avoids = true)
      : world(agents, 0.1F), at(test::scattered(agents, 9)), velocity(agents) {
    std::mt19937 engine(4);
    std::normal_distribution<float> speed(0.0F, 0.6F);
    for (std::size_t a = 0; a < agents; ++a) {
      velocity.x[a] = speed(engine);
      velocity.y[a] = speed(engine);
      velocity.z[a] = speed(engine);
    }
    world.swarms[0].avoidance = {1, 0.2F, 2.0F, 0.5F, 2.0F, 7, 2.5F, 1};
    world.swarms[1].avoidance = {second_avoids ? 1 : 0, 0.1F, 1.0F, 0.3F, 1.5F, 10, 2.0F, 0};
    for (SwarmModel& swarm : world.swarms) {
      swarm.field.low_x = 8;
      swarm.field.high_z = 16;
    }
    if (agents > 20) {
      at.x[3] = std::numeric_limits<float>::quiet_NaN();
      at.x[5] = at.x[4];  // two at one place
      at.y[5] = at.y[4];
      at.z[5] = at.z[4];
      velocity.x[9] = std::numeric_limits<float>::quiet_NaN();
      at.y[11] = 1e6F;
    }
  }

  AgentColumns columns() const { return {at.x, at.y, at.z, velocity.x, velocity.y, velocity.z}; }
};

struct Tick {
  Columns out;
  TickCounts counts;
};

// The third of three ticks, each of which starts from what the one before told.
inline Tick third_tick(Engine& engine, Crowd crowd) {
  constexpr float kPeriod = 0.02F;
  const std::size_t agents = crowd.at.x.size();
  EXPECT_TRUE(engine.prepare(crowd.world.swarms, agents));
  Tick tick{Columns(agents), {}};
  for (std::uint64_t n = 0; n < 3; ++n) {
    tick.counts = engine.compute(crowd.columns(), {n, 0.0, kPeriod}, tick.out.velocities());
    EXPECT_EQ(engine.fault(), "");
    crowd.velocity = tick.out;
  }
  return tick;
}

inline std::vector<std::uint32_t> bits(const std::vector<float>& column) {
  std::vector<std::uint32_t> words(column.size());
  std::memcpy(words.data(), column.data(), column.size() * sizeof(float));
  return words;
}

inline void expect_same(const Tick& a, const Tick& b) {
  EXPECT_EQ(bits(a.out.x), bits(b.out.x));
  EXPECT_EQ(bits(a.out.y), bits(b.out.y));
  EXPECT_EQ(bits(a.out.z), bits(b.out.z));
  EXPECT_EQ(a.counts.infeasible, b.counts.infeasible);
  EXPECT_EQ(a.counts.moved, b.counts.moved);
}

}  // namespace mayfly::test
