#include "fields/spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/reference/walls_reference.hpp"

namespace mayfly {
namespace {

TEST(SplineCoefficients, GiveEveryValueBackAtItsCentre) {
  const Grid grid{{-1.0F, 2.0F, 0.0F}, 0.5F, {12, 9, 15}};
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> any(-5, 5);
  std::vector<float> values(grid.size());
  for (float& value : values) {
    value = any(engine);
  }
  const std::vector<float> c = fields::spline_coefficients(grid, values);
  for (int k = 2; k < 13; ++k) {
    for (int j = 2; j < 7; ++j) {
      for (int i = 2; i < 10; ++i) {
        const glm::vec3 at = grid.center(i, j, k);
        EXPECT_NEAR(reference::spline(c, grid, {at.x, at.y, at.z}), values[grid.index(i, j, k)], 1e-5);
      }
    }
  }
}

TEST(SplineCoefficients, FollowABallBetweenCentres) {
  const Grid grid{{-8.0F, -8.0F, -8.0F}, 1.0F, {16, 16, 16}};
  std::vector<float> values(grid.size());
  for (int k = 0; k < 16; ++k) {
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 16; ++i) {
        const glm::vec3 c = grid.center(i, j, k);
        values[grid.index(i, j, k)] = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z) - 3.0F;
      }
    }
  }
  const std::vector<float> c = fields::spline_coefficients(grid, values);
  double through = 0, smoothed = 0;
  for (double angle = 0; angle < 6.28; angle += 0.1) {
    const reference::Vec on_surface{3 * std::cos(angle), 3 * std::sin(angle), 0.3};
    const double exact = std::sqrt(9 + 0.09) - 3;
    through = std::max(through, std::fabs(reference::spline(c, grid, on_surface) - exact));
    smoothed = std::max(smoothed, std::fabs(reference::spline(values, grid, on_surface) - exact));
  }
  EXPECT_LT(through, 0.02);
  EXPECT_GT(smoothed, 0.05) << "what the filter is there for";
}

TEST(SplineCoefficients, OfAConstantAreTheConstantEvenInOneCell) {
  for (const glm::ivec3 cells : {glm::ivec3{1, 1, 1}, glm::ivec3{2, 1, 3}, glm::ivec3{5, 2, 1}}) {
    const Grid grid{{0, 0, 0}, 1.0F, cells};
    for (const float c : fields::spline_coefficients(grid, std::vector<float>(grid.size(), 7.0F))) {
      EXPECT_NEAR(c, 7.0F, 1e-5);
    }
  }
}

}  // namespace
}  // namespace mayfly
