// Faults against the promise, a few flights of each.
#include <gtest/gtest.h>

#include "bench/faults/matrix.hpp"

namespace mayfly::bench {
namespace {

TEST(FaultMatrix, IsTheSameOnAnyNumberOfThreadsAndAgain) {
  const auto once = sweep_faults({.seeds = 1, .threads = 1});
  const auto again = sweep_faults({.seeds = 1, .threads = 2});
  ASSERT_TRUE(once && again);
  ASSERT_EQ(once->cells.size(), kFaultKinds);
  for (std::size_t i = 0; i < kFaultKinds; ++i) {
    EXPECT_EQ(once->cells[i].hash, again->cells[i].hash) << fault_row(once->cells[i].faults.front()).name;
  }
}

TEST(FaultMatrix, ASeedOfItsOwnIsAFlightOfItsOwn) {
  const auto world = make_fault_world();
  ASSERT_TRUE(world);
  const auto a = fly_with_faults(*world, {FaultKind::kWind}, 5);
  const auto b = fly_with_faults(*world, {FaultKind::kWind}, 6);
  ASSERT_TRUE(a && b);
  EXPECT_NE(a->hash, b->hash);
}

TEST(FaultMatrix, NoFlightHangs) {
  const auto matrix = sweep_faults({.seeds = 2, .threads = 1});
  ASSERT_TRUE(matrix);
  EXPECT_EQ(matrix->hung, 0U) << to_text(*matrix);
}

TEST(FaultMatrix, PairsAreEveryTwo) {
  const auto matrix = sweep_faults({.seeds = 0, .pairs = true, .threads = 1});
  ASSERT_TRUE(matrix);
  EXPECT_EQ(matrix->cells.size(), kFaultKinds * (kFaultKinds - 1) / 2);
}

}  // namespace
}  // namespace mayfly::bench
