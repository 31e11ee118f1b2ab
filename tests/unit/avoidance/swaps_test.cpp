// Agents that change places through each other: nobody overlaps at any tick, everybody arrives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/avoidance/open_field.hpp"

namespace mayfly {
namespace {

using test::OpenField;

constexpr float kRadius = 0.25F;  // m
constexpr float kRounding = 1e-4F;

std::vector<glm::vec3> circle(int agents, float radius) {
  std::vector<glm::vec3> places;
  for (int a = 0; a < agents; ++a) {
    const float turn = 2.0F * std::numbers::pi_v<float> * static_cast<float>(a) / static_cast<float>(agents);
    places.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0.0F);
  }
  return places;
}

// Evenly spread (a Fibonacci spiral).
std::vector<glm::vec3> sphere(int agents, float radius) {
  std::vector<glm::vec3> places;
  for (int a = 0; a < agents; ++a) {
    const float z = 1.0F - (2.0F * static_cast<float>(a) + 1.0F) / static_cast<float>(agents);
    const float turn = std::numbers::pi_v<float> * (3.0F - std::sqrt(5.0F)) * static_cast<float>(a);
    const float around = std::sqrt(1.0F - z * z);
    places.emplace_back(radius * around * std::cos(turn), radius * around * std::sin(turn), radius * z);
  }
  return places;
}

std::vector<glm::vec3> opposite(std::vector<glm::vec3> places) {
  for (glm::vec3& place : places) {
    place = -place;
  }
  return places;
}

void expect_swap(const std::vector<glm::vec3>& from, int ticks, bool strict, float apart) {
  OpenField field(from, opposite(from));
  field.swarms[0].avoidance.strict = strict ? 1 : 0;
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, from.size()));
  float least = field.least_distance();
  for (int t = 0; t < ticks; ++t) {
    field.fly(*engine, 1);
    least = std::min(least, field.least_distance());
  }
  EXPECT_GE(least, apart);
  EXPECT_LT(field.farthest_from_home(), 0.1F);
  testing::Test::RecordProperty("infeasible", static_cast<int>(field.infeasible));
}

// Where everybody meets, some have no way that keeps clear of all others.
TEST(Swap, AHundredOnACircleDoNotTouch) {
  expect_swap(circle(100, 20), 1500, true, 2 * kRadius - kRounding);
}
TEST(Swap, AHundredOnASphereDoNotTouch) {
  expect_swap(sphere(100, 8), 1500, true, 2 * kRadius - kRounding);
}

// As published a jam costs a tenth of the distance, which a margin on the radius makes up for.
TEST(Swap, AHundredOnACircleAsPublished) {
  expect_swap(circle(100, 20), 1500, false, 1.8F * kRadius);
}
TEST(Swap, AHundredOnASphereAsPublished) {
  expect_swap(sphere(100, 8), 1500, false, 1.8F * kRadius);
}

TEST(Swap, TwoHeadOnAndExactlySymmetric) {
  expect_swap({{-4, 0, 0}, {4, 0, 0}}, 400, false, 2 * kRadius - kRounding);
  expect_swap({{-4, 0, 0}, {4, 0, 0}}, 400, true, 2 * kRadius - kRounding);
}
TEST(Swap, TwoHeadOnOneAboveTheOther) {
  expect_swap({{0, 0, -4}, {0, 0, 4}}, 400, false, 2 * kRadius - kRounding);
}
TEST(Swap, FourAcrossEachOther) {
  expect_swap(circle(4, 4), 400, false, 2 * kRadius - kRounding);
}

}  // namespace
}  // namespace mayfly
