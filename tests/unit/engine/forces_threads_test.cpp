// Swarms that integrate forces: the same bits on any number of threads, and no memory asked for in a tick.
#include <gtest/gtest.h>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/engine/forced_cases.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::ForcedCase;

class ForcedOnThreads : public testing::TestWithParam<ForcedCase> {};

TEST_P(ForcedOnThreads, FlyAlikeOnAnyNumber) {
  const auto alone = test::flown(*make_native_engine(1), GetParam());
  for (const int threads : {2, 3}) {
    EXPECT_TRUE(test::flown(*make_native_engine(threads), GetParam()) == alone) << threads;
  }
}

TEST_P(ForcedOnThreads, AskForNoMemoryInATick) {
  const ForcedCase& c = GetParam();
  const test::Flyers flyers = test::flyers_in_box(c.agents, 6, 6, 3);
  const std::vector<SwarmModel> swarms{test::model_of(c)};
  const auto engine = make_native_engine(2);
  ASSERT_TRUE(engine->prepare(swarms, c.agents));
  Columns out(c.agents);
  const std::uint64_t before = allocation_count();
  for (std::uint64_t tick = 0; tick < 3; ++tick) {
    engine->compute(flyers.columns(), {tick, 0.0, 0.01F}, out.velocities());
  }
  EXPECT_EQ(allocation_count(), before);
}

INSTANTIATE_TEST_SUITE_P(All, ForcedOnThreads, test::forced_cases(), test::name_of);

}  // namespace
}  // namespace mayfly
