// The quick reciprocal root, and the rows of cells that a search looks through.
#include "kernels/neighbours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mayfly {
namespace {

TEST(QuickInverse, IsWithinSevenTenMillionths) {
  double worst = 0;
  for (float exponent = -58; exponent < 60; exponent += 0.0013F) {
    const float squared = std::exp2(exponent);
    const double wanted = 1 / std::sqrt(static_cast<double>(squared));
    const double got = kernels::mf_quick_inverse(kernels::mf_splat(squared))[0];
    worst = std::max(worst, std::fabs(got / wanted - 1));
  }
  EXPECT_LE(worst, 8e-7);
}

TEST(QuickInverse, OfLessThanANanometreIsNothing) {
  for (const float squared : {0.0F, 1e-40F, 0.99e-18F}) {
    EXPECT_EQ(kernels::mf_quick_inverse(kernels::mf_splat(squared))[0], 0.0F) << squared;
  }
  EXPECT_GT(kernels::mf_quick_inverse(kernels::mf_splat(1.01e-18F))[0], 0.99e9F);
}

// Whoever is within reach of any of the eight is in a cell of the rows, inside the grid and far outside.
TEST(Rows, MissNobodyWithinReach) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<float> unit(-1, 1);
  const kernels::MfCubes cubes{-3, -2, -1, 2.5F, 17, 9, 4};
  std::size_t seen = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const float spread = std::exp2(8 * unit(engine));
    const float reach = std::exp2(3 * unit(engine));
    const auto around = [&](float middle, float extent) { return middle + extent * unit(engine); };
    const float x = around(0.4F, spread), y = around(-0.2F, spread), z = around(-0.2F, spread);
    kernels::F3 r{};
    for (int k = 0; k < 8; ++k) {
      r.x[k] = around(x, 0.2F);
      r.y[k] = around(y, 0.2F);
      r.z[k] = around(z, 0.2F);
    }
    const kernels::MfBox box = kernels::mf_box_around(r, &cubes);
    for (int neighbour = 0; neighbour < 20; ++neighbour) {
      const kernels::F3 at = kernels::mf3_splat(around(x, reach), around(y, reach), around(z, reach));
      const kernels::F3 line = kernels::mf3_sub(at, r);
      if (kernels::mf_least(kernels::mf3_dot(line, line)) > reach * reach) {
        continue;
      }
      ++seen;
      const int cell = kernels::mf_cube_index(at, &cubes)[0];
      const int cx = cell % cubes.cells_x, cy = cell / cubes.cells_x % cubes.cells_y;
      const int cz = cell / cubes.cells_x / cubes.cells_y;
      const float cells = reach * cubes.inverse;
      ASSERT_GE(cy, kernels::mf_first_cube(box.low_y, cells, cubes.cells_y));
      ASSERT_LE(cy, kernels::mf_last_cube(box.high_y, cells, cubes.cells_y));
      ASSERT_GE(cz, kernels::mf_first_cube(box.low_z, cells, cubes.cells_z));
      ASSERT_LE(cz, kernels::mf_last_cube(box.high_z, cells, cubes.cells_z));
      const kernels::MfRows rows = kernels::mf_rows(&box, cy, cz, cells, &cubes);
      ASSERT_GE(cx, rows.first[0]);
      ASSERT_LT(cx, rows.past[0]);
    }
  }
  EXPECT_GT(seen, 10000U);
}

}  // namespace
}  // namespace mayfly
