#include "fields/nested_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "fields/cost_field.hpp"
#include "tests/unit/fields_nested/look_up.hpp"

namespace mayfly::fields {
namespace {

using test::box;
using test::guide_at;
using test::make_world;
using test::NestedWorld;

float degrees_between(glm::vec3 a, glm::vec3 b) {
  return std::acos(std::clamp(glm::dot(a, b), -1.0F, 1.0F)) * 180.0F / std::numbers::pi_v<float>;
}

float percentile(std::vector<float>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

glm::vec3 direction_of(const CostField& field, std::size_t entry) {
  return {field.guide[4 * entry], field.guide[4 * entry + 1], field.guide[4 * entry + 2]};
}

TEST(NestedCost, IsExactInAnEmptyWorld) {
  const glm::vec3 center(300, 500, 700);
  const NestedWorld world = make_world({}, SphereShape{center, 10.0F}, {800, 800, 800});
  const auto field = world.cost();
  ASSERT_TRUE(field);
  EXPECT_EQ(field->unreachable, 0U);
  field->for_each_cell([&](std::size_t entry, glm::vec3 at, float) {
    const float way = glm::distance(at, center);
    ASSERT_NEAR(field->guide[4 * entry + 3], way - 10.0F, 1e-3F);
    if (way > 2.0F) {
      ASSERT_LT(degrees_between(direction_of(*field, entry), (center - at) / way), 1.0F) << way;
    }
  });
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(0.0F, 800.0F);
  for (int n = 0; n < 5000; ++n) {
    const glm::vec3 p(unit(random), unit(random), unit(random));
    if (glm::distance(p, center) > 30.0F) {
      ASSERT_LT(degrees_between(guide_at(world, *field, p).direction, glm::normalize(center - p)), 3.0F);
    }
  }
}

// Costs are compared where both grids have a cell; a dense grid's own first-order error grows with the way.
TEST(NestedCost, AgreesWithTheDenseFieldBehindASlit) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field) << field.error().message;
  const Grid fine = world.nested->fine();
  const auto distance = build_distance_field(world.solid, fine, 2, {});
  const auto goal = build_goal_distance({world.goal, {}}, fine, 2, {});
  ASSERT_TRUE(distance && goal);
  const auto dense = build_cost_field(*distance, *goal, {}, 2, {});
  ASSERT_TRUE(dense);
  EXPECT_EQ(dense->unreachable, 0U);
  EXPECT_EQ(field->unreachable, 0U);
  std::vector<float> angles;
  std::vector<float> far_angles;
  field->for_each_cell([&](std::size_t entry, glm::vec3 center, float side) {
    if (field->kind[entry] != CellKind::kReached) {
      return;
    }
    const float wanted = dense->cost_at(center);
    const float cost = field->guide[4 * entry + 3];
    // Straight ways are exact here, and an upper bound to nobody; the dense scheme is dearer off the axes.
    ASSERT_LE(cost, wanted + 0.03F * wanted + side) << center.x << ' ' << center.y << ' ' << center.z;
    ASSERT_GE(cost, wanted - 0.10F * wanted - 2.0F) << center.x << ' ' << center.y << ' ' << center.z;
    const glm::ivec3 at(center);
    const std::size_t there = fine.index(at.x, at.y, at.z);
    if (wanted > 0.0F && dense->kind[there] == CellKind::kReached) {
      const float angle = degrees_between(direction_of(*field, entry), direction_of(*dense, there));
      (side == 1.0F ? angles : far_angles).push_back(angle);
    }
  });
  // The dense scheme's own directions are off by up to some ten degrees.
  EXPECT_LT(percentile(angles, 0.5), 6.0F);
  EXPECT_LT(percentile(angles, 0.95), 25.0F);
  EXPECT_LT(percentile(far_angles, 0.5), 6.0F);
  EXPECT_LT(percentile(far_angles, 0.95), 25.0F);
}

// From one side of a coarse cell's border to the other an agent does not turn.
TEST(NestedCost, DirectionsAreContinuousAcrossTheBorderOfBricks) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field);
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  std::vector<float> turns;
  std::vector<float> usual;
  while (turns.size() < 5000) {
    glm::vec3 p = test::kSlitSize * glm::vec3(unit(random), unit(random), unit(random));
    const int axis = static_cast<int>(3.0F * unit(random));
    p[axis] = 8.0F * std::round(p[axis] / 8.0F);
    glm::vec3 low = p;
    glm::vec3 high = p;
    low[axis] -= 0.05F;
    high[axis] += 0.05F;
    if (world.solid.signed_distance(p) < 1.0F || world.goals[0].signed_distance(p) < 5.0F) {
      continue;
    }
    const auto a = guide_at(world, *field, low);
    const auto b = guide_at(world, *field, high);
    (a.fine != b.fine ? turns : usual).push_back(degrees_between(a.direction, b.direction));
  }
  EXPECT_LT(percentile(turns, 0.5), 1.0F);
  EXPECT_LT(percentile(turns, 0.95), 6.0F);
  EXPECT_LT(percentile(turns, 0.999), 30.0F);
  EXPECT_LT(percentile(usual, 0.95), 6.0F);
}

TEST(NestedCost, AgentsArriveFromEverywhereAndTouchNothing) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field);
  std::mt19937 random(13);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int n = 0; n < 300; ++n) {
    glm::vec3 p = test::kSlitSize * glm::vec3(unit(random), unit(random), unit(random));
    if (world.solid.signed_distance(p) < 1.0F) {
      continue;
    }
    const glm::vec3 start = p;
    const float straight = field->cost_at(p);
    float flown = 0.0F;
    while (world.goals[0].signed_distance(p) > 0.0F && flown < 2.0F * straight + 20.0F) {
      p += 0.1F * guide_at(world, *field, p).direction;
      flown += 0.1F;
      ASSERT_GT(world.solid.signed_distance(p), 0.0F) << start.x << ' ' << start.y << ' ' << start.z;
    }
    ASSERT_LE(world.goals[0].signed_distance(p), 0.0F) << start.x << ' ' << start.y << ' ' << start.z;
    EXPECT_LT(flown, 1.1F * straight + 4.0F) << start.x << ' ' << start.y << ' ' << start.z;
  }
}

TEST(NestedCost, AWallAcrossTheWorldIsTight) {
  const NestedWorld world = make_world({box({60, 0, 0}, {61, 128, 96})}, test::slit_goal(), test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field);
  EXPECT_GT(field->unreachable, 0U);
  EXPECT_FALSE(field->reaches({20, 64, 48}));
  EXPECT_FALSE(field->reaches({58, 64, 48}));
  EXPECT_TRUE(field->reaches({63, 64, 48}));
  EXPECT_TRUE(field->unreachable_in({{0, 0, 0}, {30, 128, 96}}).has_value());
  EXPECT_FALSE(field->unreachable_in({{66, 0, 0}, {128, 128, 96}}).has_value());
}

TEST(NestedCost, SameBitsOnAnyNumberOfThreads) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto one = world.cost({}, 1);
  const auto three = world.cost({}, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->guide, three->guide);
  EXPECT_EQ(one->kind, three->kind);
}

TEST(NestedCost, EveryEntryOfTheGuideIsFinite) {
  const NestedWorld world = make_world(test::slit(), test::slit_goal(), test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field);
  EXPECT_TRUE(std::ranges::all_of(field->guide, [](float value) { return std::isfinite(value); }));
}

TEST(NestedCost, ASmallGoalIsFoundToo) {
  const NestedWorld world =
      make_world(test::slit(), SphereShape{{100.3F, 20.6F, 30.1F}, 0.2F}, test::kSlitSize);
  const auto field = world.cost();
  ASSERT_TRUE(field);
  EXPECT_EQ(field->unreachable, 0U);
  EXPECT_NEAR(field->cost_at({100.5F, 70.5F, 30.5F}), 49.7F, 1.0F);
}

TEST(NestedCost, RefusesGoalsThatNobodyCanReach) {
  const NestedWorld outside = make_world({}, box({200, 20, 20}, {210, 30, 30}), {64, 64, 64});
  const auto a = outside.cost();
  ASSERT_FALSE(a);
  EXPECT_NE(a.error().message.find("outside"), std::string::npos);
  const NestedWorld inside =
      make_world({box({20, 20, 20}, {44, 44, 44})}, box({30, 30, 30}, {34, 34, 34}), {64, 64, 64});
  const auto b = inside.cost();
  ASSERT_FALSE(b);
  EXPECT_NE(b.error().message.find("inside obstacles"), std::string::npos);
}

TEST(NestedCost, RefusesBadParameters) {
  const NestedWorld world = make_world({}, box({30, 30, 30}, {34, 34, 34}), {64, 64, 64});
  CostParams params;
  params.length_weight = std::nanf("");
  EXPECT_FALSE(world.cost(params));
}

}  // namespace
}  // namespace mayfly::fields
