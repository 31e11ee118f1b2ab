#include "controller/engine/cell_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

constexpr CellLimits kWide{{-1e4F, -1e4F, -1e4F}, {1e4F, 1e4F, 1e4F}, 0.1F};

// Agents as a cell order takes them, with room to read past the last.
struct Unsorted {
  explicit Unsorted(test::Columns columns)
      : at(std::move(columns)), half(at.x.size() + MF_LANES, 0.1F), id(half.size()), count(at.x.size()) {
    for (std::vector<float>* column : {&at.x, &at.y, &at.z}) {
      column->resize(count + MF_LANES);
    }
    std::iota(id.begin(), id.end(), 0);
  }
  UnsortedAgents agents() const { return {at.x, at.y, at.z, half, id, count}; }

  test::Columns at;
  std::vector<float> half;
  std::vector<int> id;
  std::size_t count;
};

int cell_of(const CellOrder& order, std::size_t sorted) {
  const kernels::F3 r = kernels::mf3_splat(order.x()[sorted], order.y()[sorted], order.z()[sorted]);
  return kernels::mf_cell_index(r, &order.cells())[0];
}

class CellOrderOf : public testing::TestWithParam<std::size_t> {};

TEST_P(CellOrderOf, IsAPermutationInWhichCellsFollowEachOther) {
  const std::size_t agents = GetParam();
  const Unsorted unsorted(test::scattered(agents, 9));
  for (const int threads : {1, 3}) {
    ThreadTeam team(threads);
    CellOrder order;
    order.reserve(agents);
    order.sort(unsorted.agents(), kWide, team);
    std::vector<int> ids(order.id().begin(), order.id().begin() + static_cast<std::ptrdiff_t>(agents));
    std::sort(ids.begin(), ids.end());
    for (std::size_t a = 0; a < agents; ++a) {
      EXPECT_EQ(ids[a], static_cast<int>(a));
    }
    EXPECT_EQ(order.start()[0], 0);
    EXPECT_EQ(order.start()[order.cell_count()], static_cast<int>(agents));
    for (std::size_t c = 0; c < order.cell_count(); ++c) {
      for (int s = order.start()[c]; s < order.start()[c + 1]; ++s) {
        const auto sorted = static_cast<std::size_t>(s);
        EXPECT_EQ(order.x()[sorted], unsorted.at.x[static_cast<std::size_t>(order.id()[sorted])]);
        EXPECT_EQ(cell_of(order, sorted), static_cast<int>(c));
      }
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Sizes, CellOrderOf, testing::Values(0, 1, 2, 8, 500, 20'000));

TEST(CellOrder, HoldsAgentsAtOnePointFarOnesAndSuchAsHaveNoPlace) {
  test::Columns at(6);
  at.x = {5, 5, 5, 1e30F, std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()};
  const Unsorted unsorted(at);
  ThreadTeam team(1);
  CellOrder order;
  order.reserve(6);
  order.sort(unsorted.agents(), kWide, team);
  EXPECT_EQ(order.start()[order.cell_count()], 6);
}

// Two clumps at the corners of a large box: cells as wide as the box would allow hold hundreds each.
TEST(CellOrder, MakesCellsSmallerWhereASwarmCrowds) {
  constexpr std::size_t kAgents = 4000;
  test::Columns at = test::scattered(kAgents, 4);
  for (std::size_t a = 0; a < kAgents; a += 2) {
    at.x[a] += 500;
    at.y[a] += 500;
    at.z[a] += 500;
  }
  const Unsorted unsorted(at);
  ThreadTeam team(1);
  CellOrder order;
  order.reserve(kAgents);
  order.sort(unsorted.agents(), kWide, team);
  EXPECT_GT(order.mean_company(), 100);
  for (int tick = 0; tick < 40; ++tick) {
    order.sort(unsorted.agents(), kWide, team);
  }
  EXPECT_LT(order.mean_company(), 15);
}

}  // namespace
}  // namespace mayfly
