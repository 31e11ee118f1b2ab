#include "core/nested_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <set>

namespace mayfly {
namespace {

// 3 × 2 × 2 coarse cells of 4 m, bricks of half-metre cells in two of them.
NestedGrid two_bricks() {
  NestedGrid nested{{{-2.0F, 1.0F, 0.0F}, 4.0F, {3, 2, 2}}, std::vector<int>(12, NestedGrid::kNoBrick), 2};
  nested.brick[1] = 12;
  nested.brick[8] = 12 + NestedGrid::kBrickEntries;
  return nested;
}

TEST(NestedGrid, LeavesCoverTheWorldOnce) {
  const NestedGrid nested = two_bricks();
  double volume = 0.0;
  std::set<std::size_t> entries;
  nested.for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    volume += std::pow(static_cast<double>(leaf.side), 3.0);
    EXPECT_TRUE(entries.insert(leaf.entry).second) << leaf.entry;
    EXPECT_LT(leaf.entry, nested.entries());
  });
  EXPECT_DOUBLE_EQ(volume, 12.0 * 64.0);
  EXPECT_EQ(entries.size(), 10U + 2U * 512U);
}

TEST(NestedGrid, EveryPointFindsTheCellsAroundIt) {
  const NestedGrid nested = two_bricks();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int n = 0; n < 20000; ++n) {
    glm::vec3 p =
        nested.coarse.origin + glm::vec3(12, 8, 8) * glm::vec3(unit(random), unit(random), unit(random));
    if (n % 4 == 0) {  // on the faces of coarse cells
      p.x = nested.coarse.origin.x + 4.0F * std::floor((p.x - nested.coarse.origin.x) / 4.0F);
    }
    const Lattice cells = nested.lattice_at(p);
    const glm::vec3 u = (p - cells.grid.origin) / cells.grid.cell - 0.5F;
    const bool fine = cells.first != 0;
    const glm::ivec3 at = nested.coarse_cell(p);
    EXPECT_EQ(fine, nested.brick_at(at) != NestedGrid::kNoBrick);
    for (int axis = 0; fine && axis < 3; ++axis) {
      // Eight cells around p, and the three nearest along each axis, lie in the brick.
      EXPECT_GE(u[axis], 0.4999F);
      EXPECT_LE(u[axis], static_cast<float>(NestedGrid::kBrickSide) - 1.4999F);
    }
  }
}

TEST(NestedGrid, ACoreCellsCentreFindsItself) {
  const NestedGrid nested = two_bricks();
  nested.for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    const Lattice cells = nested.lattice_at(leaf.center);
    const glm::ivec3 at((leaf.center - cells.grid.origin) / cells.grid.cell);
    EXPECT_EQ(cells.entry(at), leaf.entry);
    EXPECT_EQ(cells.grid.cell, leaf.side);
  });
}

TEST(NestedGrid, BrokenAndFarPointsFindSomeCell) {
  const NestedGrid nested = two_bricks();
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 1e30F, -1e30F}) {
    EXPECT_TRUE(nested.holds(nested.coarse_cell(glm::vec3(bad)))) << bad;
    EXPECT_TRUE(nested.holds(nested.coarse_cell({0.0F, bad, 1.0F}))) << bad;
  }
}

}  // namespace
}  // namespace mayfly
