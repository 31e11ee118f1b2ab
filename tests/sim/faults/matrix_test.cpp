// Faults against the promise, a few flights of each.
#include <gtest/gtest.h>

#include <numeric>
#include <string>

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

std::uint64_t breaches_of(const FaultCell& cell) {
  return std::accumulate(cell.breaches.begin(), cell.breaches.end(), std::uint64_t{0});
}

TEST(FaultMatrix, EveryFaultIsSeenAndAnsweredInTimeAndBreaksNoPromise) {
  const auto matrix = sweep_faults({.seeds = 20});
  ASSERT_TRUE(matrix);
  for (const FaultCell& cell : matrix->cells) {
    const std::string name(fault_row(cell.faults.front()).name);
    EXPECT_EQ(breaches_of(cell), 0U) << name << ", first of seed " << cell.first_bad.value_or(0);
    EXPECT_EQ(cell.hung, 0U) << name;
    EXPECT_EQ(cell.unseen, 0U) << name << " is not seen";
    EXPECT_EQ(cell.late, 0U) << name << " is seen late: " << cell.seen.longest << " s";
    EXPECT_LE(cell.safe_after.value_or(0), 1U) << name << ": ticks to the safe command";
  }
  EXPECT_EQ(matrix->breaches + matrix->hung + matrix->unseen + matrix->late + matrix->slow, 0U);
}

TEST(FaultMatrix, TwoFaultsAtOnceHangNothingAndBreakNoPromise) {
  const auto matrix = sweep_faults({.seeds = 1, .pairs = true});
  ASSERT_TRUE(matrix);
  ASSERT_EQ(matrix->cells.size(), kFaultKinds * (kFaultKinds - 1) / 2);
  for (const FaultCell& cell : matrix->cells) {
    const std::string name =
        std::string(fault_row(cell.faults[0]).name) + " + " + std::string(fault_row(cell.faults[1]).name);
    EXPECT_EQ(cell.hung, 0U) << name;
    EXPECT_EQ(breaches_of(cell), 0U) << name << ", seed " << cell.first_bad.value_or(0);
  }
}

}  // namespace
}  // namespace mayfly::bench
