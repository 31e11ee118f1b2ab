#include "controller/engine/cell_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

class CellOrderOf : public testing::TestWithParam<std::size_t> {};

TEST_P(CellOrderOf, IsAPermutationInWhichCellsFollowEachOther) {
  const std::size_t agents = GetParam();
  const test::Columns at = test::scattered(agents, 9);
  const std::vector<float> half(agents, 0.1F);
  CellOrder order;
  order.reserve(agents);
  order.sort(at.positions(), half, 0.2F);
  const kernels::MfCells& cells = order.cells();
  EXPECT_GE(1 / cells.inverse_cell, 0.2F * 0.9999F);
  std::vector<int> ids(order.id().begin(), order.id().begin() + static_cast<std::ptrdiff_t>(agents));
  std::sort(ids.begin(), ids.end());
  for (std::size_t a = 0; a < agents; ++a) {
    EXPECT_EQ(ids[a], static_cast<int>(a));
  }
  const int count = cells.nx * cells.ny * cells.nz;
  EXPECT_EQ(order.start()[0], 0);
  EXPECT_EQ(order.start()[static_cast<std::size_t>(count)], static_cast<int>(agents));
  for (int c = 0; c < count; ++c) {
    for (int s = order.start()[static_cast<std::size_t>(c)];
         s < order.start()[static_cast<std::size_t>(c) + 1]; ++s) {
      const auto body = order.body(static_cast<std::size_t>(s));
      EXPECT_EQ(body.x, at.x[static_cast<std::size_t>(body.id)]);
      const int cx = kernels::mf_cell_of(body.x, cells.origin_x, cells.inverse_cell, cells.nx);
      const int cy = kernels::mf_cell_of(body.y, cells.origin_y, cells.inverse_cell, cells.ny);
      const int cz = kernels::mf_cell_of(body.z, cells.origin_z, cells.inverse_cell, cells.nz);
      EXPECT_EQ((cz * cells.ny + cy) * cells.nx + cx, c);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Sizes, CellOrderOf, testing::Values(0, 1, 2, 8, 500, 20'000));

TEST(CellOrder, HoldsAgentsAtOnePointAndFarOnes) {
  test::Columns at(4);
  at.x = {5, 5, 5, 1e7F};
  const std::vector<float> half(4, 0.1F);
  CellOrder order;
  order.reserve(4);
  order.sort(at.positions(), half, 0.1F);
  EXPECT_LE(static_cast<std::size_t>(order.cells().nx) * static_cast<std::size_t>(order.cells().ny),
            CellOrder::most_cells(4));
  at.x[1] = std::numeric_limits<float>::quiet_NaN();
  order.sort(at.positions(), half, 0.1F);
  EXPECT_EQ(order.start()[0], 0);
}

}  // namespace
}  // namespace mayfly
