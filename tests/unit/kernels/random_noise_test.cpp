// The other noises: against double, and their statistics.
#include "kernels/random_noise.h"

#include <gtest/gtest.h>

#include "tests/reference/draw_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;

constexpr float kRms = 1.07F;  // m/s, the two blocks'

MfNoise noise_of_kind(int kind) {
  MfNoise noise = test::noise_of(7, 0.4F, 0.25F);
  noise.kind = kind;
  noise.rms_speed = kRms;
  return noise;
}

MfMoment tick_of(std::uint32_t n) {
  MfMoment moment{};
  moment.key_a = reference::mixed(2 * n);
  moment.key_b = reference::mixed(2 * n + 1);
  return moment;
}

TEST(WhiteNoise, EqualsTheReferenceInDouble) {
  const MfNoise noise = noise_of_kind(MF_NOISE_WHITE);
  const MfMoment moment = tick_of(11);
  const Vec v = lane(mf_white_noise(mf_lane_index() + 40, &noise, &moment), 5);
  for (std::uint32_t c = 0; c < 3; ++c) {
    const double w = reference::symmetric_interval(reference::drawn(moment.key_a, moment.key_b, 45, c));
    EXPECT_NEAR(v[c], w * kRms, 1e-6);
  }
}

TEST(GaussianNoise, EqualsTheReferenceInDouble) {
  const MfNoise noise = noise_of_kind(MF_NOISE_GAUSSIAN);
  for (std::uint32_t tick = 0; tick < 500; ++tick) {
    const MfMoment moment = tick_of(tick);
    const Vec v = lane(mf_gaussian_noise(mf_lane_index() + 40, &noise, &moment), 5);
    for (std::uint32_t c = 0; c < 3; ++c) {
      const double g = reference::normal(reference::drawn(moment.key_a, moment.key_b, 45, 2 * c),
                                         reference::drawn(moment.key_a, moment.key_b, 45, 2 * c + 1));
      EXPECT_NEAR(v[c], g * kRms / std::sqrt(3.0), 5e-6);
    }
  }
}

TEST(GaussianNoise, StaysFiniteOnTheRarestDraws) {
  for (const std::uint32_t first : {0U, 255U, 256U, 0xffffffffU}) {
    for (const std::uint32_t second : {0U, 0x40000000U, 0x80000000U, 0xffffffffU}) {
      const F g = mf_normal_draw(mf_usplat(first), mf_usplat(second));
      EXPECT_NEAR(g[0], reference::normal(first, second), 2e-6);
      EXPECT_LE(std::fabs(g[0]), 5.77F) << "√(48 ln 2)";
    }
  }
}

// Moments over many agents and ticks, of one component and of the speed.
struct Moments {
  double mean = 0, square = 0, fourth = 0, speed2 = 0, cross = 0;
  double count = 0;
};

Moments moments_of(int kind) {
  const MfNoise noise = noise_of_kind(kind);
  Moments m;
  for (std::uint32_t tick = 0; tick < 200; ++tick) {
    const MfMoment moment = tick_of(tick);
    for (int first = 0; first < 2000; first += MF_LANES) {
      const F3 v = mf_other_noise(mf3_splat(0, 0, 0), mf_lane_index() + first, &noise, &moment, nullptr);
      for (int k = 0; k < MF_LANES; ++k) {
        const Vec one = lane(v, k);
        m.mean += one[0];
        m.square += one[0] * one[0];
        m.fourth += std::pow(one[0], 4);
        m.cross += one[0] * one[1];
        m.speed2 += reference::dot(one, one);
        m.count += 1;
      }
    }
  }
  for (double* sum : {&m.mean, &m.square, &m.fourth, &m.cross, &m.speed2}) {
    *sum /= m.count;
  }
  return m;
}

// Five standard deviations of each sample mean, from the exact moments of the distribution.
void expect_moments(const Moments& m, double variance, double fourth, double eighth) {
  const auto five_sigma = [&](double v) { return 5 * std::sqrt(v / m.count); };
  EXPECT_NEAR(m.mean, 0, five_sigma(variance));
  EXPECT_NEAR(m.square, variance, five_sigma(fourth - variance * variance));
  EXPECT_NEAR(m.fourth, fourth, five_sigma(eighth - fourth * fourth));
  EXPECT_NEAR(m.cross, 0, five_sigma(variance * variance));
  EXPECT_NEAR(m.speed2, 3 * variance, five_sigma(3 * (fourth - variance * variance)));
}

TEST(WhiteNoise, HasTheMomentsOfAUniformOne) {
  const double a = static_cast<double>(kRms);  // uniform in ±a: E x²ⁿ = a²ⁿ/(2n + 1)
  expect_moments(moments_of(MF_NOISE_WHITE), a * a / 3, std::pow(a, 4) / 5, std::pow(a, 8) / 9);
}

TEST(GaussianNoise, HasTheMomentsOfANormalOne) {
  const double v = static_cast<double>(kRms) * static_cast<double>(kRms) / 3;  // E x⁴ = 3v², E x⁸ = 105v⁴
  expect_moments(moments_of(MF_NOISE_GAUSSIAN), v, 3 * v * v, 105 * std::pow(v, 4));
}

TEST(PerlinNoise, IsThePotentialScaledToTheSpeedOfItsCurl) {
  MfNoise noise = noise_of_kind(MF_NOISE_PERLIN);
  noise.octaves = 2;
  noise.inverse_scale[1] = 0.8F;
  noise.gain[1] = 0.1F;
  const MfMoment still{};
  test::Points points(200);
  double curl2 = 0, perlin2 = 0;
  for (int n = 0; n < 60'000; ++n) {
    const F3 x = all_lanes(points.next());
    const Vec v = lane(mf_perlin_noise(x, &noise, &still, nullptr));
    const Vec c = lane(mf_curl_noise(x, &noise, nullptr));
    perlin2 += reference::dot(v, v);
    curl2 += reference::dot(c, c);
  }
  // A sample rms of n speeds is off by about 1/√(4n): 0.2 %, and the check figures have three digits.
  EXPECT_NEAR(std::sqrt(perlin2 / curl2), 1, 0.015);
  const Vec x{3.25, -1.5, 7.125};
  const reference::Slots first = reference::hashed_slots(7);
  const reference::Slots second = reference::hashed_slots(7 + 0x9e3779b9U);
  const double k = 1.718 / (std::sqrt(3.0) * 0.269);
  const Vec wanted = reference::potential(x, 0.4, 0.25 / 0.4 * k, first) +
                     reference::potential(x, 1.25, 0.1 / 1.25 * k, second);
  EXPECT_LT(reference::norm(lane(mf_perlin_noise(all_lanes(x), &noise, &still, nullptr)) - wanted), 1e-4);
}

}  // namespace
}  // namespace mayfly::kernels
