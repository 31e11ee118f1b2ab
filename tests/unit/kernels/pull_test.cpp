#include "kernels/pull.h"

#include <gtest/gtest.h>

#include "tests/reference/draw_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;

constexpr MfPull kLamp{MF_PULL_LAMP, 1.0F, 2.0F, 3.0F, 10.0F, 0.5F, 1.0F};
constexpr MfPull kBrush{MF_PULL_BRUSH, 1.0F, 2.0F, 3.0F, 4.0F, 1.5F, 0.0F};
const Vec kCenter{1, 2, 3};

Vec pulled(const MfPull& pull, Vec x, std::uint32_t tick = 1, int id = 0) {
  MfMoment moment{};
  moment.key_a = reference::mixed(tick);
  moment.key_b = reference::mixed(tick + 0x10000U);
  return lane(mf_pull(all_lanes(x), mf_isplat(id), &pull, &moment, MF_STREAM_PULL));
}

TEST(Lamp, PullsStraightWithItsWholeSpeedWithinItsReach) {
  test::Points points(5);
  for (int n = 0; n < 200; ++n) {
    const Vec x = kCenter + points.next();
    const Vec line = kCenter - x;
    EXPECT_LT(reference::norm(pulled(kLamp, x) - line * (0.5 / reference::norm(line))), 1e-6);
  }
  EXPECT_GT(reference::norm(pulled(kLamp, kCenter + Vec{9.99, 0, 0})), 0.49);
  EXPECT_EQ(reference::norm(pulled(kLamp, kCenter + Vec{10.01, 0, 0})), 0);
  EXPECT_EQ(reference::norm(pulled(kLamp, kCenter)), 0) << "no direction there, and no NaN";
}

TEST(Lamp, PushesWhereItsSpeedIsNegative) {
  MfPull lamp = kLamp;
  lamp.speed = -0.5F;
  EXPECT_LT(reference::norm(pulled(lamp, kCenter + Vec{2, 0, 0}) - Vec{0.5, 0, 0}), 1e-6);
}

class LampOfProbability : public testing::TestWithParam<float> {};

TEST_P(LampOfProbability, IsFeltByThatShareOfAgentsAndTicks) {
  constexpr int kAgents = 400, kTicks = 500;
  const double p = static_cast<double>(GetParam());
  MfPull lamp = kLamp;
  lamp.probability = GetParam();
  std::vector<int> of_agent(kAgents, 0);
  int felt = 0, twice = 0;
  for (int a = 0; a < kAgents; ++a) {
    bool before = false;
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      const bool now = reference::norm(pulled(lamp, {0, 0, 0}, tick, a)) > 0;
      felt += now ? 1 : 0;
      twice += now && before ? 1 : 0;
      of_agent[static_cast<std::size_t>(a)] += now ? 1 : 0;
      before = now;
    }
  }
  constexpr double kDraws = kAgents * kTicks;
  EXPECT_NEAR(felt, p * kDraws, 5 * std::sqrt(kDraws * p * (1 - p)));
  EXPECT_NEAR(twice, p * p * (kDraws - kAgents), 5 * std::sqrt(3 * kDraws * p * p * (1 - p)))
      << "one tick knows nothing of the last";
  for (const int count : of_agent) {  // 400 agents: beyond five deviations is one in 4 000 such tests
    EXPECT_NEAR(count, p * kTicks, 5 * std::sqrt(kTicks * p * (1 - p)) + 1);
  }
}
INSTANTIATE_TEST_SUITE_P(Shares, LampOfProbability, testing::Values(0.0F, 0.02F, 0.5F, 1.0F));

TEST(Brush, PullsAlongTheGradientOfItsBell) {
  test::Points points(3);
  for (int n = 0; n < 30; ++n) {
    const Vec x = kCenter + points.next();
    EXPECT_LT(reference::norm(pulled(kBrush, x) - reference::brush_velocity(x, kCenter, 4, 1.5)), 2e-4);
  }
}

TEST(Brush, ReachesItsSpeedWhereItIsSteepestAndNoMore) {
  double fastest = 0;
  for (int n = 0; n <= 5000; ++n) {
    fastest = std::max(fastest, reference::norm(pulled(kBrush, kCenter + Vec{0, n * 1e-3, 0})));
  }
  EXPECT_NEAR(fastest, 1.5, 1e-5);
  EXPECT_EQ(reference::norm(pulled(kBrush, kCenter)), 0);
  EXPECT_NEAR(reference::norm(pulled(kBrush, kCenter + Vec{0, 0, 4})), 0, 1e-6);
  EXPECT_EQ(reference::norm(pulled(kBrush, kCenter + Vec{0, 0, 400})), 0);
}

}  // namespace
}  // namespace mayfly::kernels
