#include "fields/goal.hpp"

#include <gtest/gtest.h>

#include "fields/cost_field.hpp"
#include "tests/unit/fields_cost/worlds.hpp"

namespace mayfly::fields {
namespace {

const Grid kGrid{glm::vec3(0.0F), 1.0F, glm::ivec3(12, 10, 8)};

GoalDistance goal_of(const Shape& shape) {
  auto goal = build_goal_distance({shape, {"scene.yaml", 7, 3}}, kGrid, 2, {});
  EXPECT_TRUE(goal);
  return std::move(*goal);
}

Result<CostField> field_of(const Shape& shape, const worlds::Phi& phi) {
  return build_cost_field(worlds::obstacles(kGrid, phi), goal_of(shape), {}, 2, {});
}

TEST(Goal, BoxIsSampledExactly) {
  const Box box{glm::vec3(2.2F, 2.0F, 2.0F), glm::vec3(6.0F, 7.1F, 5.0F)};
  const GoalDistance goal = goal_of(BoxShape{box});
  for (int i = 0; i < kGrid.cells.x; ++i) {
    EXPECT_NEAR(goal.distance[kGrid.index(i, 4, 3)], worlds::box_distance(kGrid.center(i, 4, 3), box), 1e-5F);
  }
}

TEST(Goal, CostInsideIsMinusTheDepth) {
  const auto field = field_of(SphereShape{glm::vec3(6.0F, 5.0F, 4.0F), 2.5F}, worlds::nothing());
  ASSERT_TRUE(field);
  const glm::vec3 p = kGrid.center(5, 4, 3);
  EXPECT_NEAR(field->cost_at(p), glm::distance(p, glm::vec3(6.0F, 5.0F, 4.0F)) - 2.5F, 1e-5F);
}

TEST(Goal, SmallerThanACellLeadsToItsMiddle) {
  const glm::vec3 middle(6.3F, 5.2F, 4.1F);
  const auto field = field_of(SphereShape{middle, 0.05F}, worlds::nothing());
  ASSERT_TRUE(field);
  const glm::vec3 p = kGrid.center(6, 4, 4);
  EXPECT_NEAR(field->cost_at(p), glm::distance(p, middle) - 0.05F, 1e-5F);
  const float* guide = &field->guide[4 * kGrid.index(6, 4, 4)];
  const glm::vec3 to = glm::normalize(middle - p);
  EXPECT_NEAR(guide[0], to.x, 1e-5F);
  EXPECT_NEAR(guide[1], to.y, 1e-5F);
  EXPECT_NEAR(guide[2], to.z, 1e-5F);
  EXPECT_EQ(field->unreachable, 0U);
}

TEST(Goal, CoversTheWorld) {
  const auto field = field_of(BoxShape{{glm::vec3(-5.0F), glm::vec3(50.0F)}}, worlds::nothing());
  ASSERT_TRUE(field);
  EXPECT_EQ(field->unreachable, 0U);
  for (std::size_t cell = 0; cell < kGrid.size(); ++cell) {
    ASSERT_LT(field->guide[4 * cell + 3], 0.0F);
  }
}

TEST(Goal, OutsideTheWorldIsRefused) {
  const auto field = field_of(SphereShape{glm::vec3(30.0F, 5.0F, 4.0F), 3.0F}, worlds::nothing());
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().cause, Cause::kCaller);
  EXPECT_NE(to_string(field.error()).find("scene.yaml:7:3: the goal lies outside the world"),
            std::string::npos)
      << to_string(field.error());
}

TEST(Goal, InsideAnObstacleIsRefused) {
  const auto wall = worlds::box(glm::vec3(1.0F), glm::vec3(9.0F));
  const auto field = field_of(SphereShape{glm::vec3(5.0F, 5.0F, 4.0F), 1.5F}, wall);
  ASSERT_FALSE(field);
  EXPECT_NE(field.error().message.find("inside obstacles"), std::string::npos) << to_string(field.error());
}

TEST(Goal, PartlyInsideAnObstacleUsesItsFreePart) {
  const auto wall = worlds::box(glm::vec3(-1.0F), glm::vec3(6.0F, 20.0F, 20.0F));
  const auto field = field_of(BoxShape{{glm::vec3(4.0F, 3.0F, 3.0F), glm::vec3(8.0F, 6.0F, 6.0F)}}, wall);
  ASSERT_TRUE(field);
  EXPECT_EQ(field->unreachable, 0U);
  EXPECT_EQ(field->blocked, 6U * 10U * 8U);
}

// The small goal's sources must not seep through a wall: what lies behind it is reached only if there is a
// way.
TEST(Goal, SmallGoalBesideAThinWall) {
  const auto wall = worlds::box(glm::vec3(6.0F, -5.0F, -5.0F), glm::vec3(6.1F, 20.0F, 20.0F));
  const auto field = field_of(SphereShape{glm::vec3(6.6F, 5.5F, 4.5F), 0.02F}, wall);
  ASSERT_TRUE(field);
  EXPECT_EQ(field->unreachable, 6U * 10U * 8U - (field->blocked > 80U ? 80U : 0U));
  EXPECT_TRUE(field->reaches(glm::vec3(10.0F, 5.0F, 4.0F)));
  EXPECT_FALSE(field->reaches(glm::vec3(2.0F, 5.0F, 4.0F)));
}

TEST(Goal, DifferentGridsAreRefused) {
  GoalDistance goal = goal_of(SphereShape{glm::vec3(5.0F), 2.0F});
  const Grid other{glm::vec3(0.0F), 1.0F, glm::ivec3(9)};
  EXPECT_FALSE(build_cost_field(worlds::obstacles(other, worlds::nothing()), goal, {}, 1, {}));
}

}  // namespace
}  // namespace mayfly::fields
