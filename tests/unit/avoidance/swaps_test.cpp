// Agents that change places through each other: nobody overlaps at any tick, everybody arrives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/avoidance/open_field.hpp"

namespace mayfly {
namespace {

using test::OpenField;

// Two bodies. They fly with a margin of a tenth of their radius, for where everybody meets some agents have
// no way that keeps all of it.
constexpr float kApart = 0.45F;

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

void expect_swap(const std::vector<glm::vec3>& from, int ticks) {
  OpenField field(from, opposite(from));
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, from.size()));
  float least = field.least_distance();
  for (int t = 0; t < ticks; ++t) {
    field.fly(*engine, 1);
    least = std::min(least, field.least_distance());
  }
  EXPECT_GE(least, kApart);
  EXPECT_LT(field.farthest_from_home(), 0.1F);
  testing::Test::RecordProperty("infeasible", static_cast<int>(field.infeasible));
}

TEST(Swap, AHundredOnACircle) {
  expect_swap(circle(100, 20), 2000);
}
TEST(Swap, AHundredOnASphere) {
  expect_swap(sphere(100, 8), 800);
}
TEST(Swap, TwoHeadOnAndExactlySymmetric) {
  expect_swap({{-4, 0, 0}, {4, 0, 0}}, 400);
}
TEST(Swap, TwoHeadOnOneAboveTheOther) {
  expect_swap({{0, 0, -4}, {0, 0, 4}}, 400);
}
TEST(Swap, FourAcrossEachOther) {
  expect_swap(circle(4, 4), 400);
}

}  // namespace
}  // namespace mayfly
