#include "kernels/noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "controller/engine/permutation.hpp"
#include "tests/reference/noise_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;
using test::noise_of;
using test::Points;

reference::Slots permuted_slots() {
  return [](std::int64_t x, std::int64_t y, std::int64_t z, int noise) {
    const auto p = [](std::int64_t i) { return kPermutation[static_cast<std::size_t>(i)]; };
    return static_cast<unsigned>(p(p(p((x + 85 * noise) & 255) + (y & 255)) + (z & 255))) & 15U;
  };
}

TEST(Noise, GivesPerlinsPublishedValue) {
  const MfJet j = mf_noise3(mf3_splat(3.14F, 42.0F, 7.0F), 0, 1, kPermutation.data());
  EXPECT_NEAR(j.value.x[0], 0.136919958784, 1e-6);
}

class NoiseAgainstReference : public testing::TestWithParam<bool> {};

TEST_P(NoiseAgainstReference, ValueAndEveryDerivative) {
  const bool permuted = GetParam();
  const std::uint32_t seed = permuted ? 0 : 0xfeedU;
  const reference::Slots slots = permuted ? permuted_slots() : reference::hashed_slots(seed);
  const auto p = [&](Vec x) { return reference::potential(x, 1, 1, slots); };
  Points points(100);
  for (int n = 0; n < 2000; ++n) {
    const Vec x = points.next();
    const MfJet j = mf_noise3(all_lanes(x), seed, permuted ? 1 : 0, kPermutation.data());
    const Vec value = p(x);
    const Vec dx = reference::derivative(p, x, 0);
    const Vec dy = reference::derivative(p, x, 1);
    const Vec dz = reference::derivative(p, x, 2);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(lane(j.value)[c], value[c], 2e-6);
      EXPECT_NEAR(lane(j.dx)[c], dx[c], 2e-5);
      EXPECT_NEAR(lane(j.dy)[c], dy[c], 2e-5);
      EXPECT_NEAR(lane(j.dz)[c], dz[c], 2e-5);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(BothHashes, NoiseAgainstReference, testing::Bool());

// Check figures of model.md §1: 200 000 random points, scale = gain = 1.
class NoiseStatistics : public testing::TestWithParam<bool> {};

TEST_P(NoiseStatistics, MatchTheModelsCheckFigures) {
  constexpr int kCount = 200'000;
  const bool permuted = GetParam();
  const MfNoise noise = noise_of(permuted ? 0 : 7, 1, 1, permuted);
  Points points(120);
  double value2 = 0, largest = 0;
  double derivative2 = 0;  // by x: of the sixteen slots, more have a y than an x or z
  std::vector<double> speeds;
  for (int n = 0; n < kCount; n += MF_LANES) {
    float column[3][MF_LANES];
    for (int k = 0; k < MF_LANES; ++k) {
      const Vec x = points.next();
      for (std::size_t c = 0; c < 3; ++c) {
        column[c][k] = static_cast<float>(x[c]);
      }
    }
    const MfJet j = mf_potential(mf3(mf_load(column[0]), mf_load(column[1]), mf_load(column[2])), &noise,
                                 kPermutation.data());
    const F3 curl = mf_curl(j);
    for (int k = 0; k < MF_LANES; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        value2 += std::pow(lane(j.value, k)[c], 2);
        largest = std::max(largest, std::fabs(lane(j.value, k)[c]));
        derivative2 += std::pow(lane(j.dx, k)[c], 2);
      }
      speeds.push_back(reference::norm(lane(curl, k)));
    }
  }
  EXPECT_NEAR(std::sqrt(value2 / (3.0 * kCount)), 0.269, 0.004);
  EXPECT_NEAR(std::sqrt(derivative2 / (3.0 * kCount)), 0.690, 0.01);
  EXPECT_LT(largest, 1.0);
  double sum = 0, square = 0;
  for (const double speed : speeds) {
    sum += speed;
    square += speed * speed;
  }
  EXPECT_NEAR(sum / kCount, 1.593, 0.03);
  EXPECT_NEAR(std::sqrt(square / kCount), 1.718, 0.03);
  std::nth_element(speeds.begin(), speeds.begin() + kCount * 99 / 100, speeds.end());
  EXPECT_NEAR(speeds[kCount * 99 / 100], 3.19, 0.1);
}
INSTANTIATE_TEST_SUITE_P(BothHashes, NoiseStatistics, testing::Bool());

TEST(Noise, TheThreeNoisesAndTwoSeedsAreUnrelated) {
  Points points(200);
  double products[4] = {};
  constexpr int kCount = 40'000;
  for (int n = 0; n < kCount; ++n) {
    const F3 q = all_lanes(points.next());
    const Vec a = lane(mf_noise3(q, 1, 0, nullptr).value);
    const Vec b = lane(mf_noise3(q, 2, 0, nullptr).value);
    products[0] += a[0] * a[1];
    products[1] += a[1] * a[2];
    products[2] += a[0] * a[2];
    products[3] += a[0] * b[0];
  }
  for (const double product : products) {
    EXPECT_LT(std::fabs(product / kCount), 0.003);  // of a variance of 0.072
  }
}

TEST(Noise, IsZeroOnItsLattice) {
  const MfJet j = mf_noise3(mf3_splat(3, -7, 12), 9, 0, nullptr);
  EXPECT_EQ(j.value.x[0], 0);
  EXPECT_EQ(j.value.y[0], 0);
  EXPECT_EQ(j.value.z[0], 0);
}

TEST(Noise, CurlOfOctavesIsTheSumOfTheirCurls) {
  MfNoise both = noise_of(5, 0.4F, 0.25F);
  both.octaves = 2;
  both.inverse_scale[1] = 1.0F / 1.5F;
  both.gain[1] = 0.7F;
  const reference::Slots first = reference::hashed_slots(5);
  const reference::Slots second = reference::hashed_slots(5U + 0x9e3779b9U);
  const auto p = [&](Vec x) {
    return reference::potential(x, 0.4F, 0.25, first) + reference::potential(x, 1.5F, 0.7F, second);
  };
  Points points(20);
  for (int n = 0; n < 200; ++n) {
    const Vec x = points.next();
    const Vec expected = reference::curl(p, x, 1e-4);
    const Vec got = lane(mf_curl_noise(all_lanes(x), &both, nullptr));
    EXPECT_LT(reference::norm(got - expected), 2e-4);
  }
}

// The number that issue and model ask for: divergence at most 1e-4 of the gradient's norm, between nodes.
TEST(Noise, SampledCurlHasNoDivergence) {
  const MfNoise noise = noise_of(11, 0.5F, 0.25F);
  const reference::Slots slots = reference::hashed_slots(11);
  const auto sampled = [&](Vec x) { return lane(mf_curl_noise(all_lanes(x), &noise, nullptr)); };
  const auto exact = [&](Vec x) {
    return reference::curl([&](Vec y) { return reference::potential(y, 0.5, 0.25, slots); }, x, 1e-4);
  };
  constexpr double kStep = 1.0 / 64;
  Points points(50);
  double worst = 0, worst_reference = 0;
  for (int tested = 0; tested < 500;) {
    const Vec x = points.next();
    const bool inside_one_cell = std::all_of(x.begin(), x.end(), [&](double c) {
      const double t = c / 0.5 - std::floor(c / 0.5);
      return t > 0.1 &&
             t < 0.9;  // the field is C¹ across lattice planes: a wide stencil must not straddle one
    });
    if (!inside_one_cell) {
      continue;
    }
    const auto [divergence, gradient] = reference::divergence_and_gradient(sampled, x, kStep);
    const auto [reference_divergence, reference_gradient] =
        reference::divergence_and_gradient(exact, x, kStep);
    if (reference_gradient < 0.5) {
      continue;
    }
    worst = std::max(worst, std::fabs(divergence) / gradient);
    worst_reference = std::max(worst_reference, std::fabs(reference_divergence) / reference_gradient);
    ++tested;
  }
  RecordProperty("worst_relative_divergence", std::to_string(worst));
  std::printf("worst |div|/|grad|: sampled %.2e, double-precision reference %.2e\n", worst, worst_reference);
  EXPECT_LE(worst, 1e-4);
  EXPECT_LE(worst_reference, 1e-4);
}

TEST(Noise, SurvivesWhatIsNotANumber) {
  const MfNoise noise = noise_of(1, 1, 1);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30F}) {
    static_cast<void>(mf_curl_noise(mf3_splat(bad, 0, 0), &noise, nullptr));
    static_cast<void>(mf_noise3(mf3_splat(bad, bad, bad), 0, 1, kPermutation.data()));
  }
}

}  // namespace
}  // namespace mayfly::kernels
