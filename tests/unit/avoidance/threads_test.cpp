// Any number of threads: the same bits. No allocation in a tick.
#include <gtest/gtest.h>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/avoidance/crowd.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::Crowd;
using test::Tick;

TEST(Avoidance, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Crowd crowd(9000);
  const Tick one = third_tick(*make_native_engine(1), crowd);
  EXPECT_GT(one.counts.infeasible, 0U);
  for (const int threads : {2, 3, 5}) {
    expect_same(one, third_tick(*make_native_engine(threads), crowd));
  }
}

TEST(Avoidance, AllocatesNothingInATick) {
  Crowd crowd(2000);
  const auto engine = make_native_engine(2);
  ASSERT_TRUE(engine->prepare(crowd.world.swarms, 2000));
  Columns out(2000);
  const auto before = allocation_count();
  for (std::uint64_t n = 0; n < 3; ++n) {
    engine->compute(crowd.columns(), {n, 0.0, 0.02F}, out.velocities());
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly
