#include "fields/careful_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "fields/spline.hpp"
#include "kernels/grid.h"

namespace mayfly::fields {
namespace {

const Grid kGrid{glm::vec3(-8.0F), 0.5F, glm::ivec3(32)};

struct Walls {
  Geometry solid;
  DistanceField distance;
  std::vector<float> plain, careful;

  // What the kernels see.
  static float told(const std::vector<float>& coefficients, glm::vec3 p) {
    const kernels::MfGrid lookup{kGrid.origin.x, kGrid.origin.y,    kGrid.origin.z,
                                 kGrid.cell,     1.0F / kGrid.cell, kGrid.cells.x,
                                 kGrid.cells.y,  kGrid.cells.z,     0};
    return kernels::mf_surface(kernels::mf3_splat(p.x, p.y, p.z), coefficients.data(), &lookup).value[0];
  }
};

Walls walls_of(const Shape& shape) {
  const PlacedShape placed{shape, {}};
  auto solid = Geometry::make({&placed, 1}, kGrid.cell);
  auto distance = build_distance_field(*solid, kGrid, 1, {});
  auto plain = spline_coefficients(kGrid, distance->distance);
  auto careful = plain;
  lower_walls(*solid, *distance, 1, careful);
  return {std::move(*solid), std::move(*distance), std::move(plain), std::move(careful)};
}

// m: by how much the walls tell too much at the worst of many points beside the surface.
float worst_excess(const Walls& walls, const std::vector<float>& coefficients) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-6.0F, 6.0F);
  float worst = -1.0F;
  for (int n = 0; n < 200'000; ++n) {
    const glm::vec3 p(any(random), any(random), any(random));
    const float exact = walls.solid.signed_distance(p);
    if (exact > -0.1F * kGrid.cell && exact < 0.5F * kGrid.cell) {
      worst = std::max(worst, Walls::told(coefficients, p) - exact);
    }
  }
  return worst;
}

class CarefulWalls : public ::testing::TestWithParam<std::pair<const char*, Shape>> {};

TEST_P(CarefulWalls, TellNoMoreRoomThanThereIs) {
  const Walls walls = walls_of(GetParam().second);
  EXPECT_GT(worst_excess(walls, walls.plain), 0.05F * kGrid.cell) << "nothing to be careful about";
  EXPECT_LT(worst_excess(walls, walls.careful), 0.08F * kGrid.cell);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, CarefulWalls,
    ::testing::Values(std::pair{"post", Shape(CylinderShape{{0.1F, 0.2F, -5}, {0.1F, 0.2F, 5}, 0.3F})},
                      std::pair{"ball", Shape(SphereShape{{0.1F, 0.2F, 0.3F}, 0.25F})},
                      std::pair{"box", Shape(BoxShape{{{-3.1F, -2.2F, -4.3F}, {2.7F, 3.4F, 1.9F}}})},
                      std::pair{"slab", Shape(BoxShape{{{-5, -5, -0.2F}, {5, 5, 0.15F}}})}),
    [](const auto& row) { return std::string(row.param.first); });

TEST(CarefulWalls, AreLeftAloneWhereTheyAreRight) {
  // A plane between cell centres is told exactly.
  const Walls flat = walls_of(HalfSpaceShape{{0, 0, 1}, -2.0F});
  for (std::size_t cell = 0; cell < flat.plain.size(); ++cell) {
    EXPECT_NEAR(flat.careful[cell], flat.plain[cell], 1e-4F);
  }
  const Walls ball = walls_of(SphereShape{glm::vec3(0.0F), 2.0F});
  for (int i = 0; i < kGrid.cells.x; ++i) {
    const std::size_t cell = kGrid.index(i, 2, 2);
    EXPECT_EQ(ball.careful[cell], ball.plain[cell]);  // far off
  }
}

TEST(CarefulWalls, HaveTheSameBitsOnAnyNumberOfThreads) {
  const Walls walls = walls_of(SphereShape{{0.1F, 0.2F, 0.3F}, 1.3F});
  std::vector<float> again = walls.plain;
  lower_walls(walls.solid, walls.distance, 4, again);
  EXPECT_EQ(again, walls.careful);
}

TEST(CarefulWalls, NeedNoObstacle) {
  auto nothing = Geometry::make({}, kGrid.cell);
  const auto distance = build_distance_field(*nothing, kGrid, 1, {});
  std::vector<float> walls = spline_coefficients(kGrid, distance->distance);
  const std::vector<float> before = walls;
  lower_walls(*nothing, *distance, 1, walls);
  EXPECT_EQ(walls, before);
}

}  // namespace
}  // namespace mayfly::fields
