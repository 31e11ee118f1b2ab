// Robots that land and take off by themselves.
#include "tests/unit/sim_hal/flight.hpp"

namespace mayfly::sim_hal {
namespace {

SimHalConfig above_ground(Plant plant) {
  SimHalConfig config = row_of(3, plant);
  config.ground = 9.5F;  // half a metre below the row
  return config;
}

class Landing : public ::testing::TestWithParam<Plant> {};

TEST_P(Landing, SinksToTheGroundAndStays) {
  Flight flight(above_ground(GetParam()));
  flight.commands.kind[1] = CommandKind::kLand;
  flight.ticks(50);
  EXPECT_TRUE(flight.states.telemetry[1].airborne);
  EXPECT_LT(flight.hal.truth().columns[2][1], 9.9F);
  flight.ticks(150);
  EXPECT_FALSE(flight.states.telemetry[1].airborne);
  EXPECT_TRUE(flight.states.telemetry[0].airborne);
  EXPECT_EQ(flight.hal.truth().columns[2][1], 9.5F);
  const float x = flight.hal.truth().columns[0][1];
  flight.commands.kind[1] = CommandKind::kVelocity;
  flight.ticks(50);
  EXPECT_EQ(flight.hal.truth().columns[0][1], x) << "its motors are off";
  EXPECT_EQ(flight.hal.truth().columns[3][1], 0.0F);
}

TEST_P(Landing, TakesOffAndHovers) {
  Flight flight(above_ground(GetParam()));
  flight.commands.kind.assign(3, CommandKind::kLand);
  flight.ticks(250);
  ASSERT_FALSE(flight.states.telemetry[2].airborne);
  flight.commands.kind.assign(3, CommandKind::kTakeOff);
  flight.ticks(300);
  EXPECT_TRUE(flight.states.telemetry[2].airborne);
  EXPECT_NEAR(flight.hal.truth().columns[2][2], 10.0F, 0.1F);
  EXPECT_NEAR(flight.states.speed(2), 0.0F, 1e-3F);
}

TEST_P(Landing, WithoutAGroundIsAHold) {
  Flight flight(row_of(3, GetParam()));
  flight.commands.kind.assign(3, CommandKind::kLand);
  flight.ticks(200);
  EXPECT_EQ(flight.hal.truth().columns[2][0], 10.0F);
  EXPECT_TRUE(flight.states.telemetry[0].airborne);
}

TEST_P(Landing, StopsWhereTheDeadlineFindsIt) {
  Flight flight(above_ground(GetParam()));
  flight.commands.kind.assign(3, CommandKind::kLand);
  flight.ticks(50);
  flight.now += std::chrono::seconds(10);
  ASSERT_TRUE(flight.hal.read(flight.now, flight.states.columns()).ok());
  EXPECT_TRUE(flight.states.telemetry[0].airborne);
  EXPECT_GT(flight.states.z[0], 9.6F);
}

INSTANTIATE_TEST_SUITE_P(Plants, Landing,
                         ::testing::Values(Plant::kIdeal, Plant::kVelocityLag, Plant::kDoubleIntegrator));

}  // namespace
}  // namespace mayfly::sim_hal
