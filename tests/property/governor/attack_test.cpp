// The theorem of docs/explanation/safety.md under 10⁷ agent-ticks of hostile commands: jerks, chase the
// nearest, all to one point, no numbers, what was wished long ago. 50 robots, noisy poses, dropouts, commands
// that take effect up to 1, 2 or 3 ticks late; the true motion is looked at four times a tick.
//
// Separation and fence are asked for exactly: whatever rounding takes is inside the governor's own margins.
// A command's limits are asked for up to 2⁻²⁴ of its length (bench/governor/trial.cpp derives it).
#include <gtest/gtest.h>

#include "bench/governor/trial.hpp"

namespace mayfly {
namespace {

constexpr std::uint64_t kAgentTicks = 2'000'000;  // of each of the five
constexpr std::size_t kRobots = 50;

struct Attack {
  std::uint64_t seed;
  int latency;  // ticks
  bool uneven;
};

class GovernorAttack : public testing::TestWithParam<Attack> {};

TEST_P(GovernorAttack, BreachesNothing) {
  const auto result = bench::run_trial({.agents = kRobots,
                                        .ticks = kAgentTicks / kRobots,
                                        .seed = GetParam().seed,
                                        .latency = GetParam().latency,
                                        .pose_noise = 0.01,
                                        .dropout = 0.02,
                                        .uneven = GetParam().uneven});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->agent_ticks, kAgentTicks);
  EXPECT_EQ(result->near_samples, 0U) << "least gap " << result->least_gap << " m";
  EXPECT_EQ(result->too_fast, 0U);
  EXPECT_EQ(result->too_sudden, 0U);
  EXPECT_EQ(result->outside, 0U);
  // They get near, and do not simply stand.
  EXPECT_LE(result->least_gap, 0.15);
  EXPECT_GE(result->travelled / (static_cast<double>(result->agent_ticks) * 0.01), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Of, GovernorAttack,
                         testing::Values(Attack{201, 1, false}, Attack{202, 2, false}, Attack{203, 3, false},
                                         Attack{204, 1, true}, Attack{205, 3, true}),
                         [](const auto& attack) {
                           return "Latency" + std::to_string(attack.param.latency) +
                                  (attack.param.uneven ? "Uneven" : "");
                         });

}  // namespace
}  // namespace mayfly
