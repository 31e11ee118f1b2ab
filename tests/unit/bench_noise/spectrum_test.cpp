#include "bench/noise/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace mayfly::bench {
namespace {

constexpr double kPeriod = 0.01;

std::vector<double> wave(double hz, std::size_t count) {
  std::vector<double> signal;
  for (std::size_t i = 0; i < count; ++i) {
    signal.push_back(3.0 + 2.0 * std::sin(2.0 * std::numbers::pi * hz * kPeriod * static_cast<double>(i)));
  }
  return signal;
}

TEST(Spectrum, FindsAWavesFrequencyAndLeavesItsMeanOut) {
  for (const double hz : {3.125, 12.5, 43.75}) {
    Spectrum spectrum(256, kPeriod);
    spectrum.add(wave(hz, 2048));
    EXPECT_NEAR(spectrum.centroid(), hz, 0.01);
    EXPECT_NEAR(spectrum.upper_half(), hz > 25 ? 1 : 0, 1e-9);
    const auto shares = spectrum.shares();
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
    // Hann's window spreads a wave over three lines: ⅙, ⅔, ⅙.
    const auto line = static_cast<std::size_t>(std::lround(hz * kPeriod * 256));
    EXPECT_NEAR(shares[line], 2.0 / 3, 1e-9);
    EXPECT_NEAR(shares[line + 1], 1.0 / 6, 1e-9);
  }
}

TEST(Spectrum, OfWhiteNoiseIsFlatAndOfItsDifferencesRises) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  Spectrum white(128, kPeriod), differences(128, kPeriod);
  std::vector<double> signal, difference;
  for (int i = 0; i < 400'000; ++i) {
    signal.push_back(normal(engine));
    difference.push_back(i == 0 ? 0 : signal.back() - signal[signal.size() - 2]);
  }
  white.add(signal);
  differences.add(difference);
  // The line in the middle counts as upper, and of the lowest two the mean was taken: a line is 1/64.
  EXPECT_NEAR(white.upper_half(), 0.5, 1.0 / 64);
  EXPECT_NEAR(differences.upper_half(), 0.5 + 1 / std::numbers::pi, 1.0 / 64)
      << "∫ 1 − cos ω from π/2 to π, over π";
}

TEST(Spectrum, OfNothingIsNothing) {
  Spectrum spectrum(64, kPeriod);
  EXPECT_EQ(spectrum.centroid(), 0);
  spectrum.add(std::vector<double>(63, 1.0));
  EXPECT_EQ(spectrum.windows(), 0U);
  spectrum.add(std::vector<double>(64, 7.0));
  EXPECT_EQ(spectrum.windows(), 1U);
  EXPECT_EQ(spectrum.upper_half(), 0) << "a constant has no power";
}

}  // namespace
}  // namespace mayfly::bench
