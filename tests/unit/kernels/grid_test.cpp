#include "kernels/grid.h"

#include <gtest/gtest.h>

#include <limits>

#include "kernels/ramp.h"
#include "tests/reference/walls_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly::kernels {
namespace {

using namespace kernels;
using reference::Vec;
using test::all_lanes;
using test::lane;
using test::Points;

const Grid kGrid{{-8.0F, -8.0F, -8.0F}, 1.0F, {16, 16, 16}};

MfGrid of(const Grid& g) {
  return {g.origin.x, g.origin.y, g.origin.z, g.cell, 1.0F / g.cell, g.cells.x, g.cells.y, g.cells.z, 0};
}

template <class Function>
std::vector<float> tabulate(const Grid& grid, Function f) {
  std::vector<float> table(grid.size());
  for (int k = 0; k < grid.cells.z; ++k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        const glm::vec3 c = grid.center(i, j, k);
        table[grid.index(i, j, k)] = static_cast<float>(f(Vec{c.x, c.y, c.z}));
      }
    }
  }
  return table;
}

TEST(Ramp, EqualsTheModelInAndOutsideItsRange) {
  for (double r = -0.5; r < 1.5; r += 0.01) {
    EXPECT_NEAR(mf_ramp(mf_splat(static_cast<float>(r)))[0], reference::ramp(r), 3e-7) << r;
    EXPECT_NEAR(mf_bell(mf_splat(static_cast<float>(r)))[0], reference::bell(r), 6e-7) << r;
    if (std::fabs(r) > 0.02 && std::fabs(r - 1) > 0.02) {
      const double slope = (reference::ramp(r + 1e-5) - reference::ramp(r - 1e-5)) / 2e-5;
      EXPECT_NEAR(mf_ramp_slope(mf_splat(static_cast<float>(r)))[0], slope, 1e-5) << r;
    }
  }
  EXPECT_EQ(mf_ramp(mf_splat(0.0F))[0], 0.0F);
  EXPECT_EQ(mf_ramp(mf_splat(7.0F))[0], 1.0F);
}

TEST(Sample, IsExactForLinearFieldsAndGoesOnOutside) {
  const MfGrid grid = of(kGrid);
  const auto table = tabulate(kGrid, [](Vec x) { return 1 + 2 * x[0] - 3 * x[1] + 0.5 * x[2]; });
  Points points(7.4);
  for (int n = 0; n < 500; ++n) {
    const Vec x = points.next();
    const MfCube cube = mf_cube(all_lanes(x), &grid);
    EXPECT_NEAR(mf_sample(table.data(), &cube)[0], 1 + 2 * x[0] - 3 * x[1] + 0.5 * x[2], 2e-5);
  }
  const MfCube outside = mf_cube(mf3_splat(1e6F, 0.5F, 0.5F), &grid);
  EXPECT_NEAR(mf_sample(table.data(), &outside)[0], 1 + 2 * 7.5 - 3 * 0.5 + 0.25, 2e-5);
}

TEST(Sample, ReadsInsideTheTableWhateverThePosition) {
  const Grid one{{0, 0, 0}, 2.0F, {1, 1, 1}};
  const MfGrid grid = of(one);
  const std::vector<float> table{42.0F};
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity(), 1e30F, 1.0F}) {
    const MfCube cube = mf_cube(mf3_splat(bad, bad, bad), &grid);
    EXPECT_EQ(cube.base[0], 0);
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ(mf_corner_step(&cube, k), 0);
    }
    EXPECT_EQ(mf_nearest_corner(&cube)[0], 0);
    EXPECT_EQ(mf_surface(mf3_splat(bad, bad, bad), table.data(), &grid).value[0], 42.0F);
  }
}

TEST(Surface, EqualsTheQuadraticSplineWithItsDerivatives) {
  const MfGrid grid = of(kGrid);
  Points random(1, 9);
  const auto table = tabulate(kGrid, [&](Vec) { return 3 * random.next()[0]; });
  const auto f = [&](Vec x) {
    const double s = reference::spline(table, kGrid, x);
    return Vec{s, s, s};
  };
  const auto along = [&](std::size_t axis) {
    return [&f, axis](Vec x) { return reference::derivative(f, x, axis, 1e-3); };
  };
  Points points(5);
  for (int tested = 0; tested < 100;) {
    const Vec x = points.next();
    const bool inside_one_piece = std::all_of(x.begin(), x.end(), [](double c) {
      const double t = c - std::floor(c);
      return t > 0.02 && t < 0.98;  // cell borders are the spline's knots
    });
    if (!inside_one_piece) {
      continue;
    }
    ++tested;
    const MfSurface s = mf_surface(all_lanes(x), table.data(), &grid);
    EXPECT_NEAR(s.value[0], f(x)[0], 5e-6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(lane(s.gradient)[axis], along(axis)(x)[0], 2e-5);
    }
    EXPECT_NEAR(s.xx[0], reference::derivative(along(0), x, 0)[0], 1e-4);
    EXPECT_NEAR(s.yy[0], reference::derivative(along(1), x, 1)[0], 1e-4);
    EXPECT_NEAR(s.zz[0], reference::derivative(along(2), x, 2)[0], 1e-4);
    EXPECT_NEAR(s.xy[0], reference::derivative(along(0), x, 1)[0], 1e-4);
    EXPECT_NEAR(s.xz[0], reference::derivative(along(0), x, 2)[0], 1e-4);
    EXPECT_NEAR(s.yz[0], reference::derivative(along(1), x, 2)[0], 1e-4);
  }
}

}  // namespace
}  // namespace mayfly::kernels
