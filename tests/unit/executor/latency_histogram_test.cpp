#include "controller/executor/latency_histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace mayfly {
namespace {

using namespace std::chrono_literals;

TEST(LatencyHistogram, KnowsNothingOfNothing) {
  const LatencyHistogram histogram;
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_FALSE(histogram.percentiles().has_value());
  EXPECT_EQ(histogram.percentile(0.5), 0ns);
}

TEST(LatencyHistogram, OneValueIsEveryPercentile) {
  LatencyHistogram histogram;
  histogram.record(1234567ns);
  for (const double fraction : {0.0, 0.5, 0.999, 1.0}) {
    EXPECT_EQ(histogram.percentile(fraction), 1234567ns);  // a bucket never reports more than the maximum
  }
}

TEST(LatencyHistogram, SmallValuesAreExact) {
  LatencyHistogram histogram;
  for (int ns = 0; ns < 256; ++ns) {
    histogram.record(Time(ns));
  }
  for (int ns = 0; ns < 256; ++ns) {
    EXPECT_EQ(histogram.percentile((ns + 1) / 256.0), Time(ns));
  }
}

TEST(LatencyHistogram, NegativeTimesCountAsZero) {
  LatencyHistogram histogram;
  histogram.record(-5s);
  EXPECT_EQ(histogram.count(), 1U);
  EXPECT_EQ(histogram.max(), 0ns);
  EXPECT_EQ(histogram.percentile(1.0), 0ns);
}

// Every power of two, its neighbours, and both sides of the last bucket.
TEST(LatencyHistogram, EachValueIsWithinOnePercent) {
  for (int bit = 0; bit < 37; ++bit) {
    for (const std::int64_t offset : {-1, 0, 1}) {
      const std::int64_t ns = (std::int64_t{1} << bit) + offset;
      LatencyHistogram histogram;
      histogram.record(Time(ns));
      histogram.record(200s);  // so that the maximum does not hide the bucket's error
      const double reported = static_cast<double>(histogram.percentile(0.5).count());
      EXPECT_GE(reported, static_cast<double>(ns));
      EXPECT_LE(reported, static_cast<double>(ns) * 1.01);
    }
  }
}

TEST(LatencyHistogram, WhatIsTooLongStillCountsAndTheMaximumIsExact) {
  LatencyHistogram histogram;
  histogram.record(1s);
  histogram.record(3h + 1ns);
  histogram.record(2h);
  EXPECT_EQ(histogram.count(), 3U);
  EXPECT_EQ(histogram.max(), 3h + 1ns);
  EXPECT_EQ(histogram.percentile(1.0), 3h + 1ns);
}

TEST(LatencyHistogram, AgreesWithASortedList) {
  std::mt19937_64 random(7);
  std::lognormal_distribution<double> times(11.0, 2.5);  // ns: from a few to seconds
  std::vector<std::int64_t> all;
  LatencyHistogram histogram;
  for (int i = 0; i < 100000; ++i) {
    all.push_back(static_cast<std::int64_t>(times(random)));
    histogram.record(Time(all.back()));
  }
  std::sort(all.begin(), all.end());
  for (const double fraction : {0.001, 0.1, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * 100000.0));
    const double wanted = static_cast<double>(all[rank - 1]);
    const double reported = static_cast<double>(histogram.percentile(fraction).count());
    EXPECT_GE(reported, wanted);
    EXPECT_LE(reported, wanted * 1.01) << fraction;
  }
  const Percentiles p = *histogram.percentiles();
  EXPECT_DOUBLE_EQ(p.max, static_cast<double>(all.back()) * 1e-3);
  EXPECT_NEAR(p.p99, static_cast<double>(all[98999]) * 1e-3, p.p99 * 0.01);
}

}  // namespace
}  // namespace mayfly
