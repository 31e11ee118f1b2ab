#include "kernels/draw.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/reference/draw_reference.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;

constexpr int kWords = 1 << 24;  // as many values as a draw can have

F lanes_from(int first) {
  return mf_to_float(mf_lane_index() + first);
}

TEST(Log, IsAsGoodAsFloatOnEveryValueThatIsDrawn) {
  double worst = 0;
  for (int n = 1; n < kWords; n += MF_LANES) {
    const F a = lanes_from(n) * 0x1p-24F;
    const F got = mf_log(a);
    for (int k = 0; k < MF_LANES; ++k) {
      const double wanted = std::log(static_cast<double>(a[k]));
      const double error = std::fabs(static_cast<double>(got[k]) - wanted);
      worst = std::max(worst, wanted == 0 ? error : error / std::fabs(wanted));
    }
  }
  std::printf("ln: worst relative error %.2e\n", worst);
  EXPECT_LE(worst, 5 * 0x1p-24);  // rounding of the quotient, of two products and of two sums
}

TEST(Log, HoldsForEveryNormalNumber) {
  for (const float a :
       {1e-37F, 1e-20F, 0.70710677F, 0.70710683F, 1.0F, 1.4142135F, 1.4142137F, 7.0F, 1e20F, 3e38F}) {
    const double wanted = std::log(static_cast<double>(a));
    EXPECT_NEAR(mf_log(mf_splat(a))[0], wanted, 5 * 0x1p-24 * std::fabs(wanted)) << a;
  }
}

TEST(SinTurns, IsAsGoodAsFloatOnEveryValueThatIsDrawn) {
  double worst = 0;
  for (int n = 0; n < kWords; n += MF_LANES) {
    const F a = lanes_from(n) * 0x1p-24F;
    const F got = mf_sin_turns(a);
    for (int k = 0; k < MF_LANES; ++k) {
      const double wanted = std::sin(2 * std::numbers::pi * static_cast<double>(a[k]));
      worst = std::max(worst, std::fabs(static_cast<double>(got[k]) - wanted));
    }
  }
  std::printf("sin: worst error %.2e\n", worst);
  EXPECT_LE(worst, 2.5 * 0x1p-24);  // of the angle, of the last product and of the last sum, for |sin| ≤ 1
  EXPECT_EQ(mf_sin_turns(mf_splat(0.25F))[0], 1.0F);
  EXPECT_EQ(mf_sin_turns(mf_splat(0.75F))[0], -1.0F);
  EXPECT_EQ(mf_sin_turns(mf_splat(0.5F))[0], 0.0F);
}

MfMoment keys(std::uint32_t a, std::uint32_t b) {
  MfMoment moment{};
  moment.key_a = a;
  moment.key_b = b;
  return moment;
}

TEST(Draw, IsTheDocumentedHash) {
  for (const int first : {0, 8, 1'000'000, -16}) {
    const MfMoment moment = keys(0x12345678U, 0x9abcdef0U);
    const U got = mf_draw(&moment, mf_lane_index() + first, 17);
    for (int k = 0; k < MF_LANES; ++k) {
      EXPECT_EQ(got[k],
                reference::drawn(moment.key_a, moment.key_b, static_cast<std::uint32_t>(first + k), 17));
    }
  }
}

// Draws along one of the counters while the others stand still.
enum class Along { kAgents, kTicks, kStreams };

std::vector<double> draws_along(Along along, int count) {
  std::vector<double> draws;
  for (int n = 0; n < count; ++n) {
    const auto step = static_cast<std::uint32_t>(n);
    // Keys as unlike each other as the host's Philox makes them.
    const std::uint32_t tick = along == Along::kTicks ? step : 5;
    const MfMoment moment =
        keys(reference::mixed(tick * 2654435761U), reference::mixed(tick * 0x85ebca6bU + 1));
    const I id = mf_isplat(along == Along::kAgents ? n : 3);
    const std::uint32_t stream = along == Along::kStreams ? step : 0;
    draws.push_back(static_cast<double>(mf_unit_interval(mf_draw(&moment, id, stream))[0]));
  }
  return draws;
}

class DrawsAlong : public testing::TestWithParam<Along> {};

TEST_P(DrawsAlong, AreUniformAndKnowNothingOfTheirNeighbours) {
  constexpr int kCount = 1 << 18;
  constexpr int kBins = 256;
  constexpr double kExpected = static_cast<double>(kCount) / kBins;
  const std::vector<double> draws = draws_along(GetParam(), kCount);
  std::array<int, kBins> bins{};
  double product = 0;
  for (int n = 0; n < kCount; ++n) {
    const double u = draws[static_cast<std::size_t>(n)];
    ++bins[static_cast<std::size_t>(u * kBins)];
    product += (u - 0.5) * (draws[static_cast<std::size_t>((n + 1) % kCount)] - 0.5);
  }
  double chi2 = 0;
  for (const int bin : bins) {
    chi2 += std::pow(bin - kExpected, 2) / kExpected;
  }
  // χ² of kBins − 1 degrees has variance 2 (kBins − 1); a product of two uniform draws has 1/144.
  EXPECT_NEAR(chi2, kBins - 1, 5 * std::sqrt(2.0 * (kBins - 1)));
  EXPECT_NEAR(product / kCount, 0, 5 / 12.0 / std::sqrt(kCount));
}
INSTANTIATE_TEST_SUITE_P(Counters, DrawsAlong,
                         testing::Values(Along::kAgents, Along::kTicks, Along::kStreams));

}  // namespace
}  // namespace mayfly::kernels
