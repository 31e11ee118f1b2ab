// What is around a pair: crowds, walls, bounds, agents that avoid nobody or are not there.
#include <gtest/gtest.h>

#include <random>

#include "fields/spline.hpp"
#include "tests/unit/avoidance/open_field.hpp"

namespace mayfly {
namespace {

using test::OpenField;

constexpr float kRadius = 0.25F;  // m

void expect_numbers(const OpenField& field) {
  for (std::size_t a = 0; a < field.at.x.size(); ++a) {
    EXPECT_TRUE(std::isfinite(field.at.x[a] + field.at.y[a] + field.at.z[a])) << a;
    EXPECT_LE(glm::length(field.velocity.at(a)), OpenField::avoidance().most_speed + 1e-3F) << a;
  }
}

TEST(Avoidance, PartsCoincidentAgentsOfEqualVelocity) {
  for (const int strict : {0, 1}) {
    OpenField field({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
    field.swarms[0].avoidance.strict = strict;
    const auto engine = make_native_engine(1);
    ASSERT_TRUE(engine->prepare(field.swarms, 3));
    field.fly(*engine, 1);
    EXPECT_GT(field.infeasible, 0U);
    field.fly(*engine, 60);
    EXPECT_GE(field.least_distance(), 2 * kRadius - 1e-3F);
    expect_numbers(field);
  }
}

TEST(Avoidance, CountsWhoCannotAvoidInACrowd) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(-4, 4);
  std::vector<glm::vec3> from;
  for (int a = 0; a < 50; ++a) {
    from.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  }
  OpenField field(from, std::vector<glm::vec3>(50, glm::vec3(0)));
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, 50));
  field.fly(*engine, 400);
  EXPECT_GT(field.infeasible, 0U);
  expect_numbers(field);
  EXPECT_GE(field.least_distance(), 1.7F * kRadius);
}

// Fifty in one point: nothing can be kept, and still they part.
TEST(Avoidance, UndoesAKnot) {
  OpenField field(std::vector<glm::vec3>(50, glm::vec3(0)), std::vector<glm::vec3>(50, glm::vec3(0)));
  field.swarms[0].field.cruise_speed = 0;
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, 50));
  field.fly(*engine, 1);
  EXPECT_GT(field.infeasible, 40U);
  field.fly(*engine, 400);
  EXPECT_GE(field.least_distance(), 2 * kRadius - 1e-3F);
  expect_numbers(field);
}

TEST(Avoidance, NobodyEntersAWallOrLeavesTheWorld) {
  constexpr int kCells = 24;
  std::vector<float> distance;
  const auto ball = [](glm::vec3 r) { return glm::length(r) - 2.0F; };
  for (int k = 0; k < kCells; ++k) {
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        distance.push_back(ball(0.5F * (glm::vec3(i, j, k) + 0.5F) - 6.0F));
      }
    }
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<float> coordinate(-5, 5);
  std::vector<glm::vec3> from;
  std::vector<glm::vec3> to;
  while (from.size() < 80) {
    const glm::vec3 r(coordinate(random), coordinate(random), coordinate(random));
    if (ball(r) > 2 * kRadius) {
      from.push_back(r);
      to.push_back(-1.3F * r);  // through the ball, and out of the box
    }
  }
  OpenField field(from, to);
  field.walls = fields::spline_coefficients({{-6, -6, -6}, 0.5F, {kCells, kCells, kCells}}, distance);
  field.guide.assign(4 * distance.size(), 0.0F);
  for (std::size_t cell = 0; cell < distance.size(); ++cell) {
    field.guide[4 * cell + 3] = -1000;
  }
  SwarmModel& swarm = field.swarms[0];
  swarm.walls = field.walls;
  swarm.guide = field.guide;
  swarm.field.grid = {-6, -6, -6, 0.5F, 2, kCells, kCells, kCells, 0};
  swarm.field.has_walls = 1;
  swarm.field.boundary = 0.5F;
  swarm.field.wall_reach = 2;
  swarm.field.low_x = swarm.field.low_y = swarm.field.low_z = -5.2F;
  swarm.field.high_x = swarm.field.high_y = swarm.field.high_z = 5.2F;
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, from.size()));
  float nearest = 10;
  for (int tick = 0; tick < 600; ++tick) {
    field.fly(*engine, 1);
    for (std::size_t a = 0; a < from.size(); ++a) {
      const glm::vec3 r = field.at.at(a);
      nearest = std::min(nearest, ball(r));
      EXPECT_LE(std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)}), 5.2F + 1e-3F);
    }
  }
  EXPECT_GE(nearest, kRadius - 0.02F);  // the spline of a ball's distance is a little off between cells
  expect_numbers(field);
}

// The second flies straight on; the first takes all of the way out.
TEST(Avoidance, GivesWayToWhoAvoidsNobody) {
  OpenField field({{-4, 0, 0}, {4, 0.1F, 0}}, {{4, 0, 0}, {-4, 0.1F, 0}});
  field.swarms[0] = field.swarm(0, 1);
  field.swarms.push_back(field.swarm(1, 1));
  field.swarms[1].avoidance.on = 0;
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, 2));
  float least = 10;
  for (int tick = 0; tick < 400; ++tick) {
    field.fly(*engine, 1);
    least = std::min(least, field.least_distance());
    EXPECT_NEAR(field.at.y[1], 0.1F, 1e-5F);
  }
  EXPECT_GE(least, 2 * kRadius - 1e-3F);
  EXPECT_LT(field.farthest_from_home(), 0.1F);
}

TEST(Avoidance, MindsNobodyWhoIsNotThere) {
  OpenField field({{-4, 0, 0}, {0, 0, 0}}, {{4, 0, 0}, {0, 0, 0}});
  OpenField alone({{-4, 0, 0}}, {{4, 0, 0}});
  field.at.y[1] = std::numeric_limits<float>::quiet_NaN();
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, 2));
  field.fly(*engine, 50);
  const auto other = make_native_engine(1);
  ASSERT_TRUE(other->prepare(alone.swarms, 1));
  alone.fly(*other, 50);
  EXPECT_EQ(field.at.at(0), alone.at.at(0));
}

// Who is in nobody's way flies exactly as preferred.
TEST(Avoidance, LeavesTheFreeAlone) {
  OpenField field({{0, 0, 0}, {0, 4, 0}}, {{20, 0, 0}, {20, 4, 0}});
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(field.swarms, 2));
  field.fly(*engine, 100);
  EXPECT_EQ(field.at.y[0], 0.0F);
  EXPECT_EQ(field.at.z[0], 0.0F);
  EXPECT_NEAR(field.at.x[0], 5.0F, 1e-4F);
}

}  // namespace
}  // namespace mayfly
