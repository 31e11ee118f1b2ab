#include "fields/eikonal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "tests/reference/eikonal_reference.hpp"
#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

using worlds::kInfinity;

struct Problem {
  Grid grid;
  std::vector<float> slowness;
  std::vector<float> cost;
};

Problem uniform(glm::ivec3 cells, float cell = 1.0F) {
  Problem p{{glm::vec3(0.0F), cell, cells}, {}, {}};
  p.slowness.assign(p.grid.size(), 1.0F);
  p.cost.assign(p.grid.size(), kInfinity);
  return p;
}

Problem random_problem(glm::ivec3 cells, unsigned seed) {
  Problem p = uniform(cells, 0.37F);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> speed(-2.0F, 2.0F);
  std::uniform_int_distribution<std::size_t> anywhere(0, p.grid.size() - 1);
  for (float& s : p.slowness) {
    s = random() % 5 == 0 ? kInfinity : std::exp(speed(random));
  }
  for (int n = 0; n < 3; ++n) {
    p.cost[anywhere(random)] = speed(random);
  }
  return p;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

class AgainstFastMarching : public testing::TestWithParam<glm::ivec3> {};

TEST_P(AgainstFastMarching, RandomSlowness) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Problem p = random_problem(GetParam(), seed);
    const glm::ivec3 n = p.grid.cells;
    const auto reference =
        reference::fast_marching(n.x, n.y, n.z, static_cast<double>(p.grid.cell), p.slowness, p.cost);
    ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
    for (std::size_t cell = 0; cell < reference.size(); ++cell) {
      if (std::isinf(reference[cell])) {
        ASSERT_TRUE(std::isinf(p.cost[cell])) << cell;
      } else {
        ASSERT_NEAR(p.cost[cell], reference[cell], 1e-5 * std::max(1.0, std::abs(reference[cell]))) << cell;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, AgainstFastMarching,
                         testing::Values(glm::ivec3(1, 1, 1), glm::ivec3(40, 1, 1), glm::ivec3(1, 40, 1),
                                         glm::ivec3(1, 1, 40), glm::ivec3(7, 9, 5), glm::ivec3(8, 8, 4),
                                         glm::ivec3(3, 17, 30), glm::ivec3(41, 33, 26)));

TEST(Eikonal, SameBitsOnAnyNumberOfThreads) {
  const Problem p = random_problem({45, 38, 41}, 9);
  std::vector<float> one = p.cost;
  const auto stats = solve_eikonal(p.grid, p.slowness, one, 1);
  ASSERT_TRUE(stats);
  for (const unsigned threads : {2U, 3U, 7U, 64U}) {
    std::vector<float> several = p.cost;
    const auto again = solve_eikonal(p.grid, p.slowness, several, threads);
    ASSERT_TRUE(again);
    EXPECT_TRUE(same_bits(one, several)) << threads;
    EXPECT_EQ(stats->sweeps, again->sweeps);
    EXPECT_EQ(stats->updates, again->updates);
  }
}

// A solution is a fixed point: solved again from itself, with every cell but the sources open, nothing moves.
TEST(Eikonal, LeavesSourcesAlone) {
  Problem p = uniform({20, 20, 20});
  p.cost[p.grid.index(3, 4, 5)] = -2.5F;
  p.cost[p.grid.index(4, 4, 5)] = 100.0F;  // dearer than a way to it, yet fixed
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_EQ(p.cost[p.grid.index(3, 4, 5)], -2.5F);
  EXPECT_EQ(p.cost[p.grid.index(4, 4, 5)], 100.0F);
  EXPECT_EQ(p.cost[p.grid.index(2, 4, 5)], -1.5F);
}

TEST(Eikonal, SerpentineReachesTheEnd) {
  // One lane, one cell wide, folded 15 times: the worst order for sweeps.
  Problem p = uniform({31, 31, 1});
  for (int y = 1; y < 31; y += 2) {
    for (int x = 0; x < 31; ++x) {
      p.slowness[p.grid.index(x, y, 0)] = kInfinity;
    }
    p.slowness[p.grid.index(y % 4 == 1 ? 30 : 0, y, 0)] = 1.0F;
  }
  p.cost[0] = 0.0F;
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_EQ(p.cost[p.grid.index(0, 30, 0)], 16.0F * 30.0F + 30.0F);
}

TEST(Eikonal, BlockedEverywhere) {
  Problem p = uniform({9, 9, 9});
  p.slowness.assign(p.grid.size(), kInfinity);
  p.slowness[5] = -1.0F;
  p.slowness[6] = 0.0F;
  p.cost[40] = 0.0F;
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_TRUE(std::all_of(p.cost.begin(), p.cost.end(), [](float c) { return c == kInfinity; }));
}

TEST(Eikonal, NoSource) {
  Problem p = uniform({9, 9, 9});
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_TRUE(std::all_of(p.cost.begin(), p.cost.end(), [](float c) { return c == kInfinity; }));
}

TEST(Eikonal, EveryCellASource) {
  Problem p = uniform({9, 9, 9});
  p.cost.assign(p.grid.size(), 3.0F);
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_TRUE(std::all_of(p.cost.begin(), p.cost.end(), [](float c) { return c == 3.0F; }));
}

TEST(Eikonal, ClosedPocketStaysUnreached) {
  Problem p = uniform({20, 20, 20});
  const auto shell = [](int i) { return i == 5 || i == 10; };
  int inside = 0;
  for (int k = 5; k <= 10; ++k) {
    for (int j = 5; j <= 10; ++j) {
      for (int i = 5; i <= 10; ++i) {
        if (shell(i) || shell(j) || shell(k)) {
          p.slowness[p.grid.index(i, j, k)] = kInfinity;
        } else {
          ++inside;
        }
      }
    }
  }
  p.cost[0] = 0.0F;
  ASSERT_TRUE(solve_eikonal(p.grid, p.slowness, p.cost, 2));
  EXPECT_EQ(std::count(p.cost.begin(), p.cost.end(), kInfinity), 6 * 6 * 6);
  EXPECT_EQ(inside, 64);
}

TEST(Eikonal, RefusesWhatIsNotANumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {nan, 1e30F}) {
    Problem p = uniform({4, 4, 4});
    p.slowness[7] = bad;
    EXPECT_FALSE(solve_eikonal(p.grid, p.slowness, p.cost, 1)) << bad;
  }
  for (const float bad : {nan, -kInfinity, 1e30F}) {
    Problem p = uniform({4, 4, 4});
    p.cost[7] = bad;
    EXPECT_FALSE(solve_eikonal(p.grid, p.slowness, p.cost, 1)) << bad;
  }
  Problem p = uniform({4, 4, 4});
  p.cost.pop_back();
  EXPECT_FALSE(solve_eikonal(p.grid, p.slowness, p.cost, 1));
  Problem none = uniform({0, 4, 4});
  EXPECT_FALSE(solve_eikonal(none.grid, none.slowness, none.cost, 1));
  Problem flat = uniform({4, 4, 4}, 0.0F);
  EXPECT_FALSE(solve_eikonal(flat.grid, flat.slowness, flat.cost, 1));
}

TEST(Eikonal, ReportsSweeps) {
  Problem p = uniform({10, 10, 10});
  p.cost[0] = 0.0F;
  int last = 0;
  const auto stats = solve_eikonal(p.grid, p.slowness, p.cost, 2, [&](int sweeps) {
    EXPECT_EQ(sweeps, last + 1);
    last = sweeps;
  });
  ASSERT_TRUE(stats);
  EXPECT_EQ(stats->sweeps, last);
}

}  // namespace
}  // namespace mayfly::fields
