#include "fields/moving_obstacles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/spline.hpp"
#include "tests/unit/fields_geometry/meshes.hpp"

namespace mayfly::fields {
namespace {

const Grid kGrid{{-3.0F, 1.0F, 0.0F}, 0.5F, {33, 29, 27}};
constexpr float kReach = 2.5F;

Geometry must(Result<Geometry> geometry) {
  EXPECT_TRUE(geometry);
  return std::move(*geometry);
}

DistanceField still_field() {
  const std::vector<PlacedShape> shapes{{BoxShape{{{2, 3, 2}, {5, 5, 9}}}, {}}};
  return *build_distance_field(must(Geometry::make(shapes, 0.5F)), kGrid, 2, {});
}

std::vector<PlacedShape> movers(const test::Folder& folder) {
  const auto file = folder.write("m.obj", test::as_obj(test::torus(1.5, 0.4, 24, 12)));
  return {{SphereShape{{0, 6, 5}, 1.2F}, {}},
          {BoxShape{{{6, 8, 3}, {7.5F, 9, 8}}}, {}},
          {MeshShape{file, {8, 5, 6}, {}, 1.0F, {}, false, {}}, {}},
          {MeshShape{file, {2, 11, 6}, {30, 0, 0}, 1.0F, {}, true, 0.3F}, {}}};
}

// The definition, cell by cell, from the exact solids.
void expect_defined(const MovingObstacles& obstacles, const DistanceField& still,
                    const std::vector<PlacedShape>& shapes, const std::vector<glm::vec3>& offsets,
                    const std::vector<float>& margins) {
  std::vector<Geometry> solids;
  for (const PlacedShape& shape : shapes) {
    solids.push_back(must(Geometry::make({&shape, 1}, 0.5F)));
  }
  for (int k = 0; k < kGrid.cells.z; ++k) {
    for (int j = 0; j < kGrid.cells.y; ++j) {
      for (int i = 0; i < kGrid.cells.x; ++i) {
        const std::size_t cell = kGrid.index(i, j, k);
        float expected = std::min(still.distance[cell], kReach);
        for (std::size_t s = 0; s < solids.size(); ++s) {
          expected =
              std::min(expected, solids[s].signed_distance(kGrid.center(i, j, k) - offsets[s]) - margins[s]);
        }
        ASSERT_NEAR(obstacles.field().distance[cell], expected, 1e-5F);
      }
    }
  }
}

TEST(MovingObstacles, AreTheLeastOfStillMovingAndReach) {
  const test::Folder folder;
  const auto shapes = movers(folder);
  const DistanceField still = still_field();
  auto obstacles = MovingObstacles::make(still, shapes, kReach, 2);
  ASSERT_TRUE(obstacles);
  const glm::vec3 none(0.0F);
  expect_defined(*obstacles, still, shapes, {none, none, none, none}, {0, 0, 0, 0});
  const std::vector<std::vector<glm::vec3>> flights{
      {{0.3F, 0, 0}, none, {-3, 1, 0.2F}, none},
      {{4, -1, 0}, {-3, -4, 1}, {-3, 1, 0.2F}, {0, 0, 3}},
      {{50, 0, 0}, {0, -9, 0}, {0, 200, 0}, {1e9F, 0, 0}},  // out of the world, some of them
      {none, none, none, none}};
  for (const auto& offsets : flights) {
    for (const auto& margins : std::vector<std::vector<float>>{{0, 0, 0, 0}, {0.7F, 0, 1.3F, 0.2F}}) {
      ASSERT_TRUE(obstacles->move(offsets, margins, 2));
      expect_defined(*obstacles, still, shapes, offsets, margins);
    }
  }
}

TEST(MovingObstacles, HaveTheSameBitsWhereverTheyCameFromAndOnAnyNumberOfThreads) {
  const test::Folder folder;
  const auto shapes = movers(folder);
  const std::vector<float> margins{0.5F, 0, 0.25F, 0};
  const std::vector<glm::vec3> there{{1.3F, 0, 0}, {0.1F, 0.2F, 0.3F}, {-3, 1, 0.2F}, {0, -1, 0}};
  std::vector<float> first;
  std::vector<float> first_walls;
  for (const int threads : {1, 2, 3, 0}) {
    auto obstacles = MovingObstacles::make(still_field(), shapes, kReach, threads);
    ASSERT_TRUE(obstacles);
    for (int detour = 0; detour < threads; ++detour) {
      const glm::vec3 away(static_cast<float>(detour), 1.0F, -0.5F);
      ASSERT_TRUE(obstacles->move(std::vector<glm::vec3>{away, -away, 2.0F * away, away},
                                  std::vector<float>{1, 0, 2, 3}, threads));
    }
    ASSERT_TRUE(obstacles->move(there, margins, threads));
    if (first.empty()) {
      first = obstacles->field().distance;
      first_walls.assign(obstacles->walls().begin(), obstacles->walls().end());
    }
    EXPECT_EQ(obstacles->field().distance, first);
    EXPECT_TRUE(std::ranges::equal(obstacles->walls(), first_walls));
    EXPECT_EQ(spline_coefficients(kGrid, first), first_walls);
  }
}

TEST(MovingObstacles, AHalfSpaceReachesEverywhere) {
  const PlacedShape flood{HalfSpaceShape{{0, 0, 1}, 2.0F}, {}};
  auto obstacles = MovingObstacles::make(still_field(), {&flood, 1}, kReach, 2);
  ASSERT_TRUE(obstacles);
  ASSERT_TRUE(obstacles->move(std::vector<glm::vec3>{{0, 0, 3.0F}}, std::vector<float>{0.5F}, 2));
  expect_defined(*obstacles, still_field(), {flood}, {{0, 0, 3.0F}}, {0.5F});
}

TEST(MovingObstacles, RefusesWhatMakesNoSense) {
  const PlacedShape ball{SphereShape{{0, 6, 5}, 1.2F}, {}};
  for (const float reach : {0.0F, -1.0F, std::nanf(""), INFINITY}) {
    EXPECT_FALSE(MovingObstacles::make(still_field(), {&ball, 1}, reach, 1));
  }
  const PlacedShape bad{SphereShape{{0, 6, 5}, -1.0F}, {"scene.yaml", 4, 2}};
  const auto refused = MovingObstacles::make(still_field(), {&bad, 1}, kReach, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("scene.yaml:4:2"), std::string::npos);
  DistanceField small = still_field();
  small.distance.pop_back();
  EXPECT_FALSE(MovingObstacles::make(small, {&ball, 1}, kReach, 1));
  auto obstacles = MovingObstacles::make(still_field(), {&ball, 1}, kReach, 1);
  ASSERT_TRUE(obstacles);
  const auto before = obstacles->field().distance;
  const std::vector<float> none{0};
  const std::vector<glm::vec3> here{glm::vec3(0.0F)};
  EXPECT_FALSE(obstacles->move({}, none, 1));
  EXPECT_FALSE(obstacles->move(here, {}, 1));
  EXPECT_FALSE(obstacles->move(std::vector<glm::vec3>{{std::nanf(""), 0, 0}}, none, 1));
  EXPECT_FALSE(obstacles->move(here, std::vector<float>{std::nanf("")}, 1));
  EXPECT_FALSE(obstacles->move(here, std::vector<float>{-0.1F}, 1));
  EXPECT_EQ(obstacles->field().distance, before);
}

TEST(MovingObstacles, ReachIsTheLongestLengthAndTwoCells) {
  EXPECT_EQ(reach_for({}, kGrid), 1.0F);
  EXPECT_EQ(reach_for(std::vector<float>{0.5F, 3.0F, 2.0F}, kGrid), 4.0F);
}

}  // namespace
}  // namespace mayfly::fields
