#include "fields/geometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

using test::Folder;
using testing::HasSubstr;

Result<Geometry> only(const Shape& shape) {
  return Geometry::make(std::vector<PlacedShape>{{shape, {}}}, 1.0F);
}

TEST(Geometry, distances_of_formulas) {
  const Geometry box = *only(BoxShape{{{0, 0, 0}, {2, 4, 6}}});
  EXPECT_FLOAT_EQ(box.signed_distance({1, 2, 3}), -1.0F);
  EXPECT_FLOAT_EQ(box.signed_distance({5, 8, 3}), 5.0F);
  const Geometry ball = *only(SphereShape{{1, 1, 1}, 2.0F});
  EXPECT_FLOAT_EQ(ball.signed_distance({1, 1, 1}), -2.0F);
  EXPECT_FLOAT_EQ(ball.signed_distance({1, 6, 1}), 3.0F);
  const Geometry can = *only(CylinderShape{{0, 0, 0}, {0, 0, 4}, 1.0F});
  EXPECT_FLOAT_EQ(can.signed_distance({0, 0, 2}), -1.0F);
  EXPECT_FLOAT_EQ(can.signed_distance({0, 0.5F, 0.25F}), -0.25F);
  EXPECT_FLOAT_EQ(can.signed_distance({4, 0, 8}), 5.0F);
  const Geometry floor = *only(HalfSpaceShape{{0, 0, 2}, 3.0F});  // z < 1.5
  EXPECT_FLOAT_EQ(floor.signed_distance({9, 9, 0}), -1.5F);
  EXPECT_FLOAT_EQ(floor.signed_distance({9, 9, 4}), 2.5F);
}

TEST(Geometry, refuses_formulas_without_extent_and_names_their_place) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Shape> bad{
      BoxShape{{{0, 0, 0}, {1, 0, 1}}},       BoxShape{{{0, 0, 0}, {1, nan, 1}}},
      SphereShape{{0, 0, 0}, 0.0F},           SphereShape{{0, nan, 0}, 1.0F},
      CylinderShape{{1, 1, 1}, {1, 1, 1}, 1}, CylinderShape{{0, 0, 0}, {1, 1, 1}, -1.0F},
      HalfSpaceShape{{0, 0, 0}, 1.0F},        HalfSpaceShape{{0, 0, 1}, nan}};
  for (const Shape& shape : bad) {
    const Result<Geometry> geometry =
        Geometry::make(std::vector<PlacedShape>{{shape, Place{"a.yaml", 7, 3}}}, 1.0F);
    ASSERT_FALSE(geometry) << shape.index();
    EXPECT_THAT(to_string(geometry.error()), HasSubstr("a.yaml:7:3: "));
  }
}

TEST(Geometry, a_mesh_is_scaled_then_turned_then_moved) {
  const Folder folder;
  const auto file = folder.write("m.obj", test::as_obj(test::cube({0, 0, 0}, {1, 2, 3})));
  // About x: (x, −z, y); then about z: (z, x, y).
  const Geometry geometry = *only(MeshShape{file, {10, 0, 0}, {90, 0, 90}, 2.0F, {}, false, {}});
  EXPECT_TRUE(geometry.contains({15.9F, 1.9F, 3.9F}));
  EXPECT_TRUE(geometry.contains({10.1F, 0.1F, 0.1F}));
  EXPECT_FALSE(geometry.contains({9.9F, 0.1F, 0.1F}));
  EXPECT_FALSE(geometry.contains({15.9F, 2.1F, 3.9F}));
  EXPECT_NEAR(geometry.signed_distance({20, 1, 2}), 4.0F, 1e-5F);
}

TEST(Geometry, fit_centres_the_turned_box_and_sets_its_longest_side) {
  const Folder folder;
  const auto file = folder.write("m.obj", test::as_obj(test::cube({10, 10, 10}, {11, 12, 13})));
  const Geometry geometry = *only(MeshShape{file, {1, 2, 3}, {0, 90, 0}, 7.0F, 6.0F, false, {}});
  EXPECT_NEAR(geometry.signed_distance({5, 2, 3}), 1.0F, 1e-5F);
  EXPECT_NEAR(geometry.signed_distance({1, 5, 3}), 1.0F, 1e-5F);
  EXPECT_NEAR(geometry.signed_distance({1, 2, 5}), 1.0F, 1e-5F);
}

TEST(Geometry, an_open_mesh_is_refused_unless_thin) {
  const Folder folder;
  const auto file = folder.write("sheet.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3 4\n");
  MeshShape sheet{file, {}, {}, 1.0F, {}, false, {}};
  const Result<Geometry> open =
      Geometry::make(std::vector<PlacedShape>{{sheet, Place{"a.yaml", 9, 5}}}, 0.5F);
  ASSERT_FALSE(open);
  EXPECT_THAT(to_string(open.error()),
              HasSubstr("a.yaml:9:5: open mesh 'sheet.obj'; found 1 hole: a loop of 4 edges"));
  sheet.thin = true;
  const Geometry by_default = *Geometry::make(std::vector<PlacedShape>{{sheet, {}}}, 0.5F);
  EXPECT_FLOAT_EQ(by_default.signed_distance({2, 2, 0}), -0.25F);
  EXPECT_FLOAT_EQ(by_default.signed_distance({2, 2, -3}), 2.75F);
  EXPECT_TRUE(by_default.contains({2, 2, 0.2F}));
  EXPECT_FALSE(by_default.contains({2, 2, 0.3F}));
  sheet.thickness = 2.0F;
  EXPECT_FLOAT_EQ(only(sheet)->signed_distance({7, 8, 0}), 4.0F);
  for (const float thickness : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    sheet.thickness = thickness;
    EXPECT_FALSE(only(sheet)) << thickness;
  }
}

TEST(Geometry, mesh_sizes_that_are_none_are_refused) {
  const Folder folder;
  const auto file = folder.write("m.obj", test::as_obj(test::cube({0, 0, 0}, {1, 2, 3})));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float size : {0.0F, -1.0F, nan, 3e38F}) {
    EXPECT_FALSE(only(MeshShape{file, {}, {}, size, {}, false, {}})) << size;
  }
  EXPECT_FALSE(only(MeshShape{file, {}, {}, 1.0F, 0.0F, false, {}}));
  EXPECT_FALSE(only(MeshShape{file, {nan, 0, 0}, {}, 1.0F, {}, false, {}}));
  EXPECT_FALSE(only(MeshShape{file, {}, {0, nan, 0}, 1.0F, {}, false, {}}));
}

TEST(Geometry, without_shapes_holds_nothing) {
  const Geometry geometry = *Geometry::make({}, 1.0F);
  EXPECT_TRUE(geometry.empty());
  EXPECT_EQ(geometry.signed_distance({1, 2, 3}), kNoObstacle);
  EXPECT_FALSE(geometry.contains({1, 2, 3}));
}

TEST(Geometry, its_hash_follows_the_content_not_the_file) {
  const Folder folder;
  const std::string obj = test::as_obj(test::cube({0, 0, 0}, {1, 2, 3}));
  const MeshShape mesh{folder.write("a.obj", obj), {}, {}, 1.0F, {}, false, {}};
  MeshShape copy = mesh;
  copy.file = folder.write("b.obj", obj);
  MeshShape moved = mesh;
  moved.position.x = 1e-3F;
  MeshShape thin = mesh;
  thin.thin = true;
  EXPECT_EQ(only(mesh)->content_hash(), only(copy)->content_hash());
  EXPECT_NE(only(mesh)->content_hash(), only(moved)->content_hash());
  EXPECT_NE(only(mesh)->content_hash(), only(thin)->content_hash());
  EXPECT_NE(only(SphereShape{{1, 2, 3}, 4})->content_hash(), only(SphereShape{{1, 2, 3}, 5})->content_hash());
}

}  // namespace
}  // namespace mayfly::fields
