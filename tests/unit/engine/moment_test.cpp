// What changes from tick to tick: keys of random draws, and noise that drifts.
#include "controller/engine/moment.hpp"

#include <gtest/gtest.h>

#include <set>

#include "controller/engine/permutation.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly {
namespace {

using kernels::MfMoment;
using kernels::MfNoise;
using reference::Vec;
using test::all_lanes;
using test::lane;

constexpr double kScale = 0.4;
constexpr double kGain = 0.25;
constexpr std::uint32_t kSeed = 21;

MfNoise drifting(float drift, bool permuted = false) {
  MfNoise noise = test::noise_of(kSeed, static_cast<float>(kScale), static_cast<float>(kGain), permuted);
  noise.drift = drift;
  return noise;
}

Vec curl_at(const MfNoise& noise, Vec x, double time_s) {
  const MfMoment moment = moment_of(noise, 1, time_s);
  return lane(kernels::mf_curl_noise_at(all_lanes(x), &noise, &moment, kPermutation.data()));
}

TEST(Moment, GivesEveryTickAndSwarmKeysOfItsOwn) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> keys;
  for (const std::uint32_t seed : {0U, 1U, 7U}) {
    MfNoise noise = drifting(0);
    noise.seed = seed;
    for (const std::uint64_t tick : {0ULL, 1ULL, 2ULL, 0xffffffffULL, 0x100000000ULL, 0x100000001ULL}) {
      const MfMoment moment = moment_of(noise, tick, 0);
      EXPECT_EQ(moment.key_a, moment_of(noise, tick, 9).key_a) << "time has no part in it";
      keys.insert({moment.key_a, moment.key_b});
    }
  }
  EXPECT_EQ(keys.size(), 18U);
}

// The potentials of the reference, each read at a place of its own.
Vec drifted_potential(Vec x, double way) {
  const reference::Slots slots = reference::hashed_slots(kSeed);
  const double scale = 1.0 / static_cast<double>(1.0F / static_cast<float>(kScale));
  const auto noise = [&](Vec at, int which) {
    return kGain * reference::noise(at * (1 / scale), slots, which);
  };
  return {noise(x + Vec{way, 0, 0}, 0), noise(x + Vec{0, way, 0}, 1), noise(x + Vec{0, 0, way}, 2)};
}

class DriftAfter : public testing::TestWithParam<double> {};

// A day of it is 43 km: the sampling point is as exact as in the first second.
TEST_P(DriftAfter, EqualsTheReferenceInDouble) {
  const MfNoise noise = drifting(0.5F);
  const double time_s = GetParam();
  test::Points points(20);
  for (int n = 0; n < 300; ++n) {
    const Vec x = points.next();
    const auto p = [&](Vec at) { return drifted_potential(at, 0.5 * time_s); };
    EXPECT_LT(reference::norm(curl_at(noise, x, time_s) - reference::curl(p, x, 2e-4)), 2e-4);
  }
}
INSTANTIATE_TEST_SUITE_P(Times, DriftAfter, testing::Values(0.0, 0.013, 7.7, 86400.01));

TEST(Drift, OfNoneGivesTheBitsOfNoiseThatStandsStill) {
  for (const bool permuted : {false, true}) {
    const MfNoise noise = drifting(0, permuted);
    test::Points points(50);
    for (int n = 0; n < 100; ++n) {
      const Vec x = points.next();
      const Vec still = lane(kernels::mf_curl_noise(all_lanes(x), &noise, kPermutation.data()));
      EXPECT_EQ(curl_at(noise, x, 1234.5), still);
      EXPECT_EQ(curl_at(drifting(0.5F, permuted), x, 0), still) << "at the start nothing has drifted";
    }
  }
}

class DriftByHash : public testing::TestWithParam<bool> {};

TEST_P(DriftByHash, StaysFreeOfDivergence) {
  const MfNoise noise = drifting(0.7F, GetParam());
  const auto v = [&](Vec x) { return curl_at(noise, x, 31.4); };
  test::Points points(8);
  double worst = 0;
  for (int tested = 0; tested < 100;) {
    const Vec x = points.next();
    // Differences across a face of any of the three lattices would not be small.
    const double way = 0.7 * 31.4;
    bool one_piece = true;
    for (const double c : x) {
      for (const double at : {c / kScale, (c + way) / kScale}) {
        const double t = at - std::floor(at);
        one_piece = one_piece && t > 0.05 && t < 0.95;
      }
    }
    const auto [divergence, gradient] = reference::divergence_and_gradient(v, x, 1.0 / 512);
    if (!one_piece || gradient < 0.5) {
      continue;
    }
    ++tested;
    worst = std::max(worst, std::fabs(divergence) / gradient);
  }
  EXPECT_LE(worst, 2e-4);
}

TEST_P(DriftByHash, ChangesSmoothlyAndCompletely) {
  const MfNoise noise = drifting(0.5F, GetParam());
  test::Points points(20);
  double step = 0, correlation = 0, square = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vec x = points.next();
    const Vec now = curl_at(noise, x, 50);
    step = std::max(step, reference::norm(curl_at(noise, x, 50.001) - now));
    correlation += reference::dot(now, curl_at(noise, x, 53));  // 1.5 m on, almost four features
    square += reference::dot(now, now);
  }
  // |∂V/∂t| = drift · |∂V/∂x|, which is at most about 20 gain/scale² with three noises of |∂²p| ≤ 10.
  EXPECT_LT(step, 0.001 * 0.5 * 20 * kGain / kScale / kScale);
  EXPECT_NEAR(correlation / square, 0, 5 / std::sqrt(3000.0));
}
INSTANTIATE_TEST_SUITE_P(BothHashes, DriftByHash, testing::Bool());

}  // namespace
}  // namespace mayfly
