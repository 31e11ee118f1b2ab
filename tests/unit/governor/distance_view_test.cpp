#include "controller/governor/distance_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mayfly {
namespace {

template <class Phi>
std::vector<float> sampled(const Grid& grid, Phi phi) {
  std::vector<float> data(grid.size());
  for (int k = 0; k < grid.cells.z; ++k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        const glm::vec3 c = grid.center(i, j, k);
        data[grid.index(i, j, k)] = static_cast<float>(phi(double(c.x), double(c.y), double(c.z)));
      }
    }
  }
  return data;
}

TEST(DistanceView, IsExactForALinearFieldAndAtTheCentres) {
  const Grid grid{{1.0F, -2.0F, 3.0F}, 0.5F, {5, 7, 4}};
  const auto plane = [](double x, double y, double z) { return 0.6 * x - 0.48 * y + 0.64 * z; };
  const std::vector<float> data = sampled(grid, plane);
  const DistanceView view{data.data(), grid};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 1000; ++n) {
    const double x = 1.25 + 2.0 * unit(random);
    const double y = -1.75 + 3.0 * unit(random);
    const double z = 3.25 + 1.5 * unit(random);
    ASSERT_NEAR(view.sample(x, y, z).value, plane(x, y, z), 1e-6);
    ASSERT_LE(view.sample(x, y, z).error, 0.5 * std::sqrt(0.75) + 1e-12);
  }
  EXPECT_EQ(view.sample(1.25, -1.75, 3.25).error, 0.0);
  EXPECT_DOUBLE_EQ(view.sample(1.5, -1.5, 3.5).error, 0.5 * std::sqrt(0.75));
}

// Spheres smaller than a cell, edges, and points outside the grid: the bound must hold for any 1-Lipschitz
// function.
TEST(DistanceView, TheErrorBoundHoldsForHarshFields) {
  const Grid grid{{0.0F, 0.0F, 0.0F}, 1.0F, {6, 6, 6}};
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-2.0, 8.0);
  for (int field = 0; field < 50; ++field) {
    const double cx = place(random), cy = place(random), cz = place(random), r = 0.2;
    const auto phi = [&](double x, double y, double z) {
      const double sphere = std::sqrt((x - cx) * (x - cx) + (y - cy) * (y - cy) + (z - cz) * (z - cz)) - r;
      const double edge = std::fmax(x - cy, y - cz) * std::sqrt(0.5);
      return field % 2 == 0 ? sphere : std::fmin(sphere, edge);
    };
    const std::vector<float> data = sampled(grid, phi);
    const DistanceView view{data.data(), grid};
    for (int n = 0; n < 2000; ++n) {
      const double x = place(random), y = place(random), z = place(random);
      const DistanceView::Sample s = view.sample(x, y, z);
      ASSERT_LE(std::fabs(s.value - phi(x, y, z)), s.error + 1e-5);
    }
  }
}

TEST(DistanceView, OneCellAndHugePlacesAreHandled) {
  const Grid grid{{0.0F, 0.0F, 0.0F}, 2.0F, {1, 1, 1}};
  const float value = 3.0F;
  const DistanceView view{&value, grid};
  EXPECT_EQ(view.sample(1.0, 1.0, 1.0).value, 3.0);
  EXPECT_EQ(view.sample(1.0, 1.0, 1.0).error, 0.0);
  EXPECT_DOUBLE_EQ(view.sample(4.0, 1.0, 1.0).error, 3.0);
  EXPECT_EQ(view.sample(1e30, -1e30, 0.0).value, 3.0);
  EXPECT_GE(view.sample(1e30, -1e30, 0.0).error, 1e30);
}

}  // namespace
}  // namespace mayfly
