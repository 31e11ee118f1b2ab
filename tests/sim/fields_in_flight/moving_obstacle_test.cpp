// Obstacles that move are never flown through: their true place at each tick is what counts.
#include <cstdio>

#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

// A swarm at rest in its goal, and something that goes right through it and back.
Scenario plough(const std::string& shape, float speed) {
  Scenario scenario =
      hall_with("{" + shape + ", path: {points: [[26, 10, 6], [3, 10, 6]], speed: 1, loop: true}}",
                "camp: {box: {min: [4, 4, 2], max: [18, 16, 10]}}",
                "count: 150, start: {box: {min: [4, 4, 2], max: [18, 16, 10]}}, goal: camp", 40);
  if (!scenario.world.obstacles.empty()) {
    scenario.world.obstacles[0].path->speed = speed;
  }
  return scenario;
}

class Plough : public ::testing::TestWithParam<const char*> {};

TEST_P(Plough, GoesThroughASwarmAndTouchesNobody) {
  for (const float speed : {0.4F, 1.2F}) {
    const Summary summary = flown(plough(GetParam(), speed));
    EXPECT_EQ(summary.penetrations, 0U) << speed << " m/s";
    EXPECT_TRUE(summary.faults.empty()) << summary.faults.front().cause;
    EXPECT_GT(summary.max_speed_mps.value_or(0), 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Plough,
                         ::testing::Values("box: {min: [24, 5, 3], max: [27, 15, 9]}",
                                           "box: {min: [25.9, 5, 3], max: [26.1, 15, 9]}",
                                           "sphere: {center: [26, 10, 6], radius: 2.5}",
                                           "cylinder: {from: [26, 10, 1], to: [26, 10, 11], radius: 1.5}"),
                         [](const auto& row) { return "number_" + std::to_string(row.index); });

// Faster than anybody may fly, it cannot be evaded: so the tests above can fail.
TEST(Plough, IsSeenToTouchWhereNobodyCanGetOutOfItsWay) {
  Scenario scenario = plough("box: {min: [22, 5, 3], max: [29, 15, 9]}", 6.0F);
  scenario.world.obstacles[0].path->loop = false;
  scenario.swarms[0].start = fields::BoxShape{{{4, 7, 4}, {10, 13, 8}}};
  scenario.swarms[0].limits.speed = scenario.swarms[0].cruise_speed;
  EXPECT_GT(flown(scenario).penetrations, 0U);
}

TEST(Plough, IsEvadedByRobotsThatLagUnderTheGovernor) {
  Scenario scenario = plough("box: {min: [24, 5, 3], max: [27, 15, 9]}", 0.8F);
  scenario.swarms[0].governor = true;
  scenario.swarms[0].count = 40;
  scenario.hals[0].sim.plant = PlantKind::kVelocityLag;
  const Summary summary = flown(scenario);
  EXPECT_EQ(summary.penetrations, 0U);
}

TEST(MovingObstacle, MayLeaveTheWorld) {
  Scenario scenario = plough("sphere: {center: [26, 10, 6], radius: 1.5}", 1.2F);
  scenario.world.obstacles[0].path->points = {{26, 10, 6}, {-40, 10, 6}};
  scenario.world.obstacles[0].path->loop = false;
  const Summary summary = flown(scenario);
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_TRUE(summary.faults.empty());
}

}  // namespace
}  // namespace mayfly::test
