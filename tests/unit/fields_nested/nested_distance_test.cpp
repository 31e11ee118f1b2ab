#include "fields/nested_distance.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>

#include "fields/distance_field.hpp"
#include "tests/unit/fields_nested/nested_worlds.hpp"

namespace mayfly::fields {
namespace {

using test::box;
using test::make_world;
using test::NestedWorld;

TEST(NestedDistance, IsTheDenseFieldAtFineCells) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto dense = build_distance_field(world.solid, world.nested->fine(), 2, {});
  ASSERT_TRUE(dense);
  std::size_t fine = 0;
  world.nested->for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    if (leaf.side == 1.0F) {
      const glm::ivec3 at(leaf.center);
      ASSERT_EQ(world.distance[leaf.entry], dense->distance[dense->grid.index(at.x, at.y, at.z)]);
      ++fine;
    } else {
      ASSERT_EQ(world.distance[leaf.entry], world.solid.signed_distance(leaf.center));
    }
  });
  EXPECT_GT(fine, 10000U);
}

TEST(NestedDistance, MeshesHaveTheirSign) {
  const std::filesystem::path block = std::filesystem::path(MAYFLY_SOURCE_DIR) / "config/meshes/block.obj";
  MeshShape mesh;
  mesh.file = block;
  mesh.position = {30, 30, 30};
  mesh.fit = 20.0F;
  const NestedWorld world = make_world({mesh}, box({50, 50, 50}, {56, 56, 56}), {64, 64, 64});
  std::size_t inside = 0;
  world.nested->for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    ASSERT_NEAR(world.distance[leaf.entry], world.solid.signed_distance(leaf.center), 1e-4F);
    inside += world.distance[leaf.entry] < 0.0F ? 1U : 0U;
  });
  EXPECT_GT(inside, 500U);
}

TEST(NestedDistance, NoPointOfACoarseLeafIsNearerThanTheReach) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  world.nested->for_each_leaf([&](const NestedGrid::Leaf& leaf) {
    if (leaf.side == 1.0F) {
      return;
    }
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 step = glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2) - 0.5F;
      const glm::vec3 p = leaf.center + leaf.side * step;
      const float phi = world.solid.signed_distance(p);
      ASSERT_TRUE(phi >= test::kReach.outside || phi <= -test::kReach.inside) << phi;
      ASSERT_GE(std::fabs(world.goals[0].signed_distance(p)), test::kReach.goal);
    }
  });
}

TEST(NestedDistance, ApronsHoldTheNeighboursCells) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const NestedGrid& nested = *world.nested;
  for (int z = 0; z < nested.coarse.cells.z; ++z) {
    nested.for_each_in_plane(z, [&](glm::ivec3 at) {
      const glm::ivec3 next = at + glm::ivec3(1, 0, 0);
      if (!nested.holds(next) || nested.brick_at(at) < 0 || nested.brick_at(next) < 0) {
        return;
      }
      for (int j = 0; j < NestedGrid::kBrickSide; ++j) {
        ASSERT_EQ(world.distance[nested.brick_lattice(at).entry({NestedGrid::kRatio + 1, j, 3})],
                  world.distance[nested.brick_lattice(next).entry({1, j, 3})]);
      }
    });
  }
}

TEST(NestedDistance, WallsNameTheBricks) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  for (std::size_t c = 0; c < world.nested->coarse.size(); ++c) {
    ASSERT_EQ(std::bit_cast<int>(world.walls[c]), std::max(world.nested->brick[c], 0));
  }
}

TEST(NestedDistance, SameBitsOnAnyNumberOfThreads) {
  const NestedWorld one = make_world(test::slit(), test::slit_goal(), test::kSlitSize, 1);
  const NestedWorld three = make_world(test::slit(), test::slit_goal(), test::kSlitSize, 3);
  EXPECT_EQ(one.nested->brick, three.nested->brick);
  EXPECT_EQ(one.distance, three.distance);
}

TEST(NestedDistance, AThousandMetresInFewBytes) {
  const NestedWorld world = make_world({box({400, 400, 0}, {440, 440, 120})},
                                       box({900, 900, 40}, {940, 940, 80}), {1000, 1000, 1000});
  // φ, spline and one swarm's guide: 24 bytes an entry.
  EXPECT_LT(24 * world.nested->entries(), std::size_t{150} << 20U);
  EXPECT_GT(world.nested->bricks, 500U);
}

TEST(NestedDistance, NoObstaclesAtAll) {
  const NestedWorld world = make_world({}, box({50, 50, 50}, {52, 52, 52}), {64, 64, 64});
  EXPECT_GT(world.nested->bricks, 0U);
  EXPECT_LT(world.nested->bricks, 30U);
  EXPECT_EQ(world.distance[0], kNoObstacle);
}

TEST(NestedDistance, RefusesSidesThatDoNotFit) {
  std::vector<Geometry> goals;
  const Geometry nothing = test::geometry({});
  const auto field =
      build_nested_distance(nothing, goals, {{0, 0, 0}, {64, 60, 64}}, 1.0F, test::kReach, 1, {});
  ASSERT_FALSE(field);
  EXPECT_NE(field.error().wanted.find("64 m"), std::string::npos) << field.error().wanted;
}

}  // namespace
}  // namespace mayfly::fields
