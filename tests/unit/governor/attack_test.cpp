// The theorem of docs/explanation/safety.md, attacked: hostile commands, noise, latency and dropouts against
// the true motion of 50 robots, four samples a tick. tests/property/governor and
// `mayfly bench governor` do the same for longer.
#include <gtest/gtest.h>

#include "bench/governor/trial.hpp"

namespace mayfly::governor_test {
namespace {

using bench::run_trial;
using bench::TrialPlan;
using bench::Wishes;

class GovernorAttack : public testing::TestWithParam<int> {};

TEST_P(GovernorAttack, NothingTouches) {
  const auto result = run_trial({.ticks = 2000,
                                 .seed = 100 + static_cast<std::uint64_t>(GetParam()),
                                 .latency = GetParam(),
                                 .pose_noise = 0.01,
                                 .dropout = 0.02,
                                 .uneven = GetParam() % 2 == 1});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->near_samples, 0U);
  EXPECT_EQ(result->too_fast, 0U);
  EXPECT_EQ(result->too_sudden, 0U);
  EXPECT_EQ(result->outside, 0U);
  EXPECT_GE(result->least_gap, 0.0);
  // They are near, and do not simply stand.
  EXPECT_LE(result->least_gap, 0.15);
  EXPECT_GE(result->travelled / (static_cast<double>(result->agent_ticks) * 0.01), 0.05);
}

INSTANTIATE_TEST_SUITE_P(LatencyInTicks, GovernorAttack, testing::Values(0, 1, 2, 3));

// So that the trial is one that can be failed.
TEST(GovernorAttack, AvoidanceAloneIsBroken) {
  const auto alone = run_trial({.ticks = 1500, .wishes = Wishes::kCentre, .governed = false});
  const auto governed = run_trial({.ticks = 1500, .wishes = Wishes::kCentre});
  ASSERT_TRUE(alone);
  ASSERT_TRUE(governed);
  EXPECT_GT(alone->near_samples, 100U);
  EXPECT_LT(alone->least_gap, -0.05);
  EXPECT_EQ(governed->breaches(), 0U);
}

TEST(GovernorAttack, ATrialIsTheSameFromTheSameSeed) {
  const TrialPlan plan{
      .agents = 20, .ticks = 300, .seed = 3, .latency = 2, .pose_noise = 0.01, .dropout = 0.1};
  EXPECT_EQ(run_trial(plan)->travelled, run_trial(plan)->travelled);
}

}  // namespace
}  // namespace mayfly::governor_test
