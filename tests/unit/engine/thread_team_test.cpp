#include "controller/engine/thread_team.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace mayfly {
namespace {

TEST(ThreadTeam, CoversEveryIndexOnceWhateverTheSizes) {
  for (const int threads : {1, 2, 3, 7}) {
    ThreadTeam team(threads);
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 63U, 64U, 1000U}) {
      std::vector<int> visits(count, 0);
      team.for_ranges(count, 8, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
          ++visits[i];
        }
      });
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), static_cast<int>(count));
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<std::ptrdiff_t>(count));
    }
  }
}

TEST(ThreadTeam, RunsManyRoundsWithoutLosingOne) {
  ThreadTeam team(3);
  std::vector<std::uint64_t> sums(3000, 0);
  for (int round = 0; round < 2000; ++round) {
    team.for_ranges(sums.size(), 8, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        sums[i] += 1;
      }
    });
  }
  EXPECT_EQ(std::count(sums.begin(), sums.end(), 2000U), 3000);
}

}  // namespace
}  // namespace mayfly
