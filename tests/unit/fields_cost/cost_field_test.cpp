#include "fields/cost_field.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

const Grid kGrid = worlds::cube(20, 20.0F);
const worlds::Phi kGoal = worlds::sphere(glm::vec3(15.0F), 2.0F);

// A hollow box: its 4³ cells inside cannot be left.
worlds::Phi pocket() {
  return worlds::unite({worlds::box(glm::vec3(2, 2, 2), glm::vec3(3, 8, 8)),
                        worlds::box(glm::vec3(7, 2, 2), glm::vec3(8, 8, 8)),
                        worlds::box(glm::vec3(2, 2, 2), glm::vec3(8, 3, 8)),
                        worlds::box(glm::vec3(2, 7, 2), glm::vec3(8, 8, 8)),
                        worlds::box(glm::vec3(2, 2, 2), glm::vec3(8, 8, 3)),
                        worlds::box(glm::vec3(2, 2, 7), glm::vec3(8, 8, 8))});
}

CostField built(const worlds::Phi& phi, const CostParams& params = {}, int threads = 2) {
  auto field =
      build_cost_field(worlds::obstacles(kGrid, phi), worlds::goal(kGrid, kGoal), params, threads, {});
  EXPECT_TRUE(field);
  return std::move(*field);
}

TEST(CostField, CountsAPocketExactly) {
  const CostField field = built(pocket());
  EXPECT_EQ(field.unreachable, 64U);
  EXPECT_EQ(field.blocked, 216U - 64U);
  EXPECT_EQ(field.unreachable_example, glm::vec3(3.5F));
  EXPECT_EQ(describe_unreachable(field, "exit"),
            "64 free cells cannot reach goal 'exit', for instance at (3.5, 3.5, 3.5)");
  EXPECT_FALSE(field.reaches(glm::vec3(5.0F)));
  EXPECT_TRUE(field.reaches(glm::vec3(10.0F)));
  EXPECT_TRUE(field.unreachable_in({glm::vec3(6.0F), glm::vec3(9.0F)}));
  EXPECT_FALSE(field.unreachable_in({glm::vec3(8.0F), glm::vec3(19.0F)}));
}

TEST(CostField, NothingUnreachableNothingSaid) {
  const CostField field = built(worlds::nothing());
  EXPECT_EQ(describe_unreachable(field, "exit"), "");
  EXPECT_FALSE(field.unreachable_example);
}

// The closed surface is the same with walls far thinner than a cell, wherever they fall between the centres.
TEST(CostField, ThinWallsAreTight) {
  for (const float at : {9.5F, 9.75F, 9.999F, 10.0F, 10.25F}) {
    const auto wall = worlds::box(glm::vec3(at, -9.0F, -9.0F), glm::vec3(at + 0.01F, 40.0F, 40.0F));
    const CostField field = built(wall);
    EXPECT_FALSE(field.reaches(glm::vec3(2.0F, 10.0F, 10.0F))) << at;
    EXPECT_TRUE(field.reaches(glm::vec3(18.0F, 10.0F, 10.0F))) << at;
  }
}

TEST(CostField, APassageOneCellWideIsOpen) {
  const auto wall = worlds::unite({worlds::box(glm::vec3(9, -9, -9), glm::vec3(11, 10, 40)),
                                   worlds::box(glm::vec3(9, 11, -9), glm::vec3(11, 40, 40))});
  EXPECT_EQ(built(wall).unreachable, 0U);
  CostParams stout;
  stout.clearance = 0.6F;
  EXPECT_FALSE(built(wall, stout).reaches(glm::vec3(2.0F)));
}

TEST(CostField, RepulsionLengthensWaysBesideWalls) {
  const auto wall = worlds::box(glm::vec3(9, 4, -9), glm::vec3(11, 40, 40));
  CostParams none;
  none.repulsion_weight = 0.0F;
  const glm::vec3 start(2.0F, 15.0F, 10.0F);
  const float plain = built(wall, none).cost_at(start);
  const float repelled = built(wall).cost_at(start);
  EXPECT_GT(repelled, plain);
  // g is at most 1: no place costs more than (A + B)/A a metre.
  EXPECT_LT(repelled, plain * (1.0F / 0.6F));
  CostParams doubled;  // only the ratio of the weights counts in C/A
  doubled.length_weight = 1.2F;
  doubled.repulsion_weight = 0.8F;
  EXPECT_NEAR(built(wall, doubled).cost_at(start), repelled, 1e-4F);
}

TEST(CostField, SameBitsOnAnyNumberOfThreads) {
  std::mt19937 random(3);
  const auto world = worlds::unite(worlds::random_boxes(random, 20.0F, 8));
  const CostField one = built(world, {}, 1);
  for (const int threads : {2, 3, 0}) {
    const CostField several = built(world, {}, threads);
    EXPECT_TRUE(std::equal(one.guide.begin(), one.guide.end(), several.guide.begin(), several.guide.end(),
                           [](float a, float b) { return std::bit_cast<int>(a) == std::bit_cast<int>(b); }));
    EXPECT_EQ(one.kind, several.kind);
  }
}

TEST(CostField, EveryCellOfTheGuideIsSane) {
  std::mt19937 random(4);
  for (int world = 0; world < 10; ++world) {
    auto boxes = worlds::random_boxes(random, 20.0F, 12);
    boxes.push_back(pocket());
    const auto phi = worlds::unite(boxes);
    const auto obstacles = worlds::obstacles(kGrid, phi);
    const auto field = build_cost_field(obstacles, worlds::goal(kGrid, kGoal), {}, 2, {});
    if (!field) {
      continue;  // the goal happens to be buried
    }
    for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
      const float* g = &field->guide[4 * cell];
      const float length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
      ASSERT_TRUE(std::isfinite(length) && std::isfinite(g[3]));
      ASSERT_LT(length, 1.8F);
      if (field->kind[cell] == CellKind::kReached && g[3] > 0.0F) {
        ASSERT_NEAR(length, 1.0F, 1e-4F);
      }
      if (field->kind[cell] == CellKind::kUnreachable) {
        ASSERT_EQ(length, 0.0F);
        ASSERT_EQ(g[3], kUnreachableGuide);
      } else {
        ASSERT_LT(g[3], 1000.0F);
      }
    }
  }
}

TEST(CostField, OneCellWorld) {
  const Grid grid{glm::vec3(0.0F), 1.0F, glm::ivec3(1)};
  const auto field = build_cost_field(worlds::obstacles(grid, worlds::nothing()),
                                      worlds::goal(grid, worlds::sphere(glm::vec3(0.5F), 0.3F)), {}, 2, {});
  ASSERT_TRUE(field);
  EXPECT_NEAR(field->cost_at(glm::vec3(0.2F)), -0.3F, 1e-6F);
}

TEST(CostField, OutsideAndNotANumberReachNothing) {
  const CostField field = built(worlds::nothing());
  EXPECT_FALSE(field.reaches(glm::vec3(-0.1F, 5.0F, 5.0F)));
  EXPECT_FALSE(field.reaches(glm::vec3(5.0F, 20.1F, 5.0F)));
  EXPECT_FALSE(field.reaches(glm::vec3(std::nanf(""))));
  EXPECT_TRUE(field.reaches(glm::vec3(20.0F)));
}

TEST(CostField, RefusesBadParameters) {
  const auto obstacles = worlds::obstacles(kGrid, worlds::nothing());
  const auto goal = worlds::goal(kGrid, kGoal);
  const float nan = std::nanf("");
  const CostParams bad[] = {{0.0F},
                            {-1.0F},
                            {nan},
                            {0.6F, -0.1F},
                            {0.6F, nan},
                            {0.6F, 0.4F, -1.0F},
                            {0.6F, 0.4F, nan},
                            {0.6F, 0.4F, 0.0F, -1.0F},
                            {0.6F, 0.4F, 0.0F, nan}};
  for (const CostParams& params : bad) {
    EXPECT_FALSE(build_cost_field(obstacles, goal, params, 1, {}));
  }
  auto broken = obstacles;
  broken.distance[17] = nan;
  EXPECT_FALSE(build_cost_field(broken, goal, {}, 1, {}));
}

TEST(CostField, ComesBackFromItsGuide) {
  const auto obstacles = worlds::obstacles(kGrid, pocket());
  const CostField field = built(pocket());
  const CostField again = restore_cost_field(obstacles, {}, field.guide);
  EXPECT_EQ(field.kind, again.kind);
  EXPECT_EQ(field.blocked, again.blocked);
  EXPECT_EQ(field.unreachable, again.unreachable);
  EXPECT_EQ(field.unreachable_example, again.unreachable_example);
}

TEST(CostField, KeyChangesWithEveryInput) {
  const auto obstacles = worlds::obstacles(kGrid, pocket());
  const auto goal = worlds::goal(kGrid, kGoal);
  const std::string key = cost_key(obstacles, goal, {});
  EXPECT_EQ(key, cost_key(obstacles, goal, {}));
  EXPECT_NE(key, cost_key(obstacles, goal, {0.61F}));
  EXPECT_NE(key, cost_key(obstacles, goal, {0.6F, 0.41F}));
  EXPECT_NE(key, cost_key(obstacles, goal, {0.6F, 0.4F, 3.0F}));
  EXPECT_NE(key, cost_key(obstacles, goal, {0.6F, 0.4F, 0.0F, 0.7F}));
  auto moved = goal;
  moved.distance[5] += 0.01F;
  EXPECT_NE(key, cost_key(obstacles, moved, {}));
  auto dug = obstacles;
  dug.distance[5] += 0.01F;
  EXPECT_NE(key, cost_key(dug, goal, {}));
}

}  // namespace
}  // namespace mayfly::fields
