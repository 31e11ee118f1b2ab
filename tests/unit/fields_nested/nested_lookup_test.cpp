#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/fields_nested/look_up.hpp"

namespace mayfly::fields {
namespace {

using test::all_lanes;
using test::make_world;
using test::NestedWorld;

// Of a linear function every trilinear look-up gives the function, in bricks and between coarse cells.
TEST(NestedLookup, IsExactForLinearFunctions) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const NestedGrid& nested = *world.nested;
  const auto linear = [](glm::vec3 p) { return 0.5F * p.x - 0.25F * p.y + 2.0F * p.z; };
  std::vector<float> table(4 * nested.entries());  // the third of four columns
  for (int z = 0; z < nested.coarse.cells.z; ++z) {
    nested.for_each_in_plane(z, [&](glm::ivec3 at) {
      table[4 * nested.coarse_lattice().entry(at) + 2] = linear(nested.coarse.center(at.x, at.y, at.z));
      for (int e = 0; nested.brick_at(at) >= 0 && e < NestedGrid::kBrickEntries; ++e) {
        const glm::ivec3 local(e % 10, e / 10 % 10, e / 100);
        const Lattice own = nested.brick_lattice(at);
        table[4 * own.entry(local) + 2] = linear(own.center(local));
      }
    });
  }
  const kernels::MfGrid grid = test::kernel_grid(nested);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  int fine = 0;
  for (int n = 0; n < 20000; ++n) {
    glm::vec3 p = 4.0F + (test::kSlitSize - 8.0F) * glm::vec3(unit(random), unit(random), unit(random));
    if (n % 3 == 0) {
      p.y = std::max(8.0F * std::floor(p.y / 8.0F), 8.0F);  // on a border of coarse cells
    }
    const kernels::MfAround around = kernels::mf_around(all_lanes(p), world.walls.data(), &grid);
    kernels::F sampled[4];
    kernels::mf_around_sample4(table.data(), &around, &grid, sampled);
    ASSERT_NEAR(sampled[2][5], linear(p), 1e-3F);
    fine += around.place.fine[5] != 0 ? 1 : 0;
  }
  EXPECT_GT(fine, 2000);
  EXPECT_LT(fine, 18000);
}

TEST(NestedLookup, BrokenAndFarPointsStayInTheTable) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const kernels::MfGrid grid = test::kernel_grid(*world.nested);
  const auto entries = static_cast<int>(world.nested->entries());
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 1e30F, -1e30F, -1e-6F, 128.0F}) {
    for (const glm::vec3 p : {glm::vec3(bad), glm::vec3(bad, 60, 40), glm::vec3(62, 60, bad)}) {
      const kernels::MfAround around = kernels::mf_around(all_lanes(p), world.walls.data(), &grid);
      for (const kernels::I& corner : around.corners.corner) {
        EXPECT_GE(corner[0], 0) << bad;
        EXPECT_LT(corner[0], entries) << bad;
      }
      const kernels::MfSurface wall =
          kernels::mf_around_surface(all_lanes(p), &around, world.walls.data(), &grid);
      EXPECT_TRUE(std::isfinite(wall.value[0])) << bad;
    }
  }
}

TEST(NestedLookup, WallsAreFeltWhereTheyAre) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const kernels::MfGrid grid = test::kernel_grid(*world.nested);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  int near = 0;
  for (int n = 0; n < 20000; ++n) {
    const glm::vec3 p = test::kSlitSize * glm::vec3(unit(random), unit(random), unit(random));
    const float phi = world.solid.signed_distance(p);
    const kernels::MfAround around = kernels::mf_around(all_lanes(p), world.walls.data(), &grid);
    const bool felt =
        kernels::mf_place_near_wall(&around.place, world.walls.data(), &around.corners, &grid, 3.0F)[2] != 0;
    if (phi > 4.0F) {
      EXPECT_FALSE(felt) << phi;
    } else if (phi > -1.0F && phi < 2.0F) {
      EXPECT_TRUE(felt) << phi;
      const kernels::MfSurface wall =
          kernels::mf_around_surface(all_lanes(p), &around, world.walls.data(), &grid);
      // The spline rounds edges off by a little.
      EXPECT_NEAR(wall.value[2], phi, 0.35F);
      ++near;
    }
  }
  EXPECT_GT(near, 500);
}

// One agent near a wall and seven far away: none disturbs another.
TEST(NestedLookup, LanesDoNotDisturbEachOther) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const kernels::MfGrid grid = test::kernel_grid(*world.nested);
  kernels::F3 mixed = all_lanes({20, 20, 20});
  mixed.x[3] = 58.5F;
  const kernels::MfAround around = kernels::mf_around(mixed, world.walls.data(), &grid);
  const kernels::I felt =
      kernels::mf_place_near_wall(&around.place, world.walls.data(), &around.corners, &grid, 3.0F);
  const kernels::MfSurface wall = kernels::mf_around_surface(mixed, &around, world.walls.data(), &grid);
  for (int lane = 0; lane < 8; ++lane) {
    EXPECT_EQ(felt[lane] != 0, lane == 3);
    EXPECT_TRUE(std::isfinite(wall.value[lane]));
  }
  EXPECT_NEAR(wall.value[3], 1.5F, 0.01F);
}

}  // namespace
}  // namespace mayfly::fields
