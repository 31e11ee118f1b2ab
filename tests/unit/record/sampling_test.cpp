#include "record/sampling.hpp"

#include <gtest/gtest.h>

namespace mayfly::record {
namespace {

std::uint64_t taken(const Sampling& sampling, std::uint64_t from, std::uint64_t to) {
  std::uint64_t count = 0;
  for (std::uint64_t tick = from; tick < to; ++tick) {
    count += sampling.takes(tick) ? 1 : 0;
  }
  return count;
}

TEST(Sampling, TakesTheFirstTickAndThenTheRate) {
  const Sampling sampling(20.0, 100.0);
  EXPECT_TRUE(sampling.takes(0));
  EXPECT_FALSE(sampling.takes(4));
  EXPECT_TRUE(sampling.takes(5));
  EXPECT_EQ(taken(sampling, 0, 1000), 200U);
}

TEST(Sampling, DoesNotDriftWhereRatesDoNotDivide) {
  const Sampling sampling(30.0, 100.0);
  for (std::uint64_t hour = 1; hour < 10'000; hour *= 10) {
    EXPECT_EQ(taken(sampling, hour * 360'000, hour * 360'000 + 1000), 300U);
  }
  EXPECT_EQ(taken(sampling, std::uint64_t{1} << 60U, (std::uint64_t{1} << 60U) + 1000), 300U);
}

TEST(Sampling, TakesEveryTickWhereMoreIsWanted) {
  EXPECT_EQ(taken(Sampling(500.0, 100.0), 0, 100), 100U);
}

TEST(Sampling, TakesTheFirstTickOnlyWhereNextToNothingIsWanted) {
  EXPECT_EQ(taken(Sampling(0.0, 100.0), 0, 10'000), 1U);
}

}  // namespace
}  // namespace mayfly::record
