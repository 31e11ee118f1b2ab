// Wang14's "two blocks", both variants, over and over: what each expects of itself must not hang on a seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

class TwoBlocks : public ::testing::TestWithParam<const char*> {};

TEST_P(TwoBlocks, KeepsItsWordForSeedsOneToTwenty) {
  double worst_mde = 0.0;
  double least_separation = 1e9;
  double least_reached = 1.0;
  for (int seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Flown flown = fly(scenario_file(GetParam()), {"--seed", std::to_string(seed), "--threads", "1"});
    ASSERT_LE(flown.exit_code, 1);
    expect_kept(flown);
    EXPECT_EQ(flown.summary["seed"], seed);
    EXPECT_EQ(flown.number("collisions"), 0);
    EXPECT_EQ(flown.number("reached_fraction"), 1.0);
    worst_mde = std::max(worst_mde, flown.number("mde_percent"));
    least_separation = std::min(least_separation, flown.number("min_separation_m"));
    least_reached = std::min(least_reached, flown.number("reached_fraction"));
  }
  std::printf("%s, 20 seeds: MDE moved %.3f %% at most, separation %.5f m at least, reached %.4g at least\n",
              GetParam(), worst_mde, least_separation, least_reached);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, TwoBlocks, ::testing::Values("two_blocks_passage", "two_blocks_around"),
                         [](const auto& name) { return std::string(name.param); });

}  // namespace
}  // namespace mayfly::test
