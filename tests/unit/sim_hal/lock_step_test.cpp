#include <cstdlib>
#include <cstring>

#include "tests/unit/sim_hal/flight.hpp"

namespace mayfly::sim_hal {
namespace {

TEST(LockStep, TimeGoesOnInWholePlantSteps) {
  Flight flight(row_of(1, Plant::kIdeal));
  flight.tick();
  const Time start = flight.now - Flight::kTick;
  flight.hal.read(start + std::chrono::microseconds(14999), flight.states.columns());
  EXPECT_EQ(flight.states.stamp[0], start + std::chrono::milliseconds(10));
  EXPECT_NEAR(flight.states.x[0], 0.01F, 1e-6F);
  flight.hal.read(start + std::chrono::microseconds(15000), flight.states.columns());
  EXPECT_EQ(flight.states.stamp[0], start + std::chrono::milliseconds(15));
  EXPECT_NEAR(flight.states.x[0], 0.015F, 1e-6F);
}

TEST(LockStep, TimeDoesNotGoBack) {
  Flight flight(row_of(1, Plant::kIdeal));
  flight.ticks(10);
  const Time stamp = flight.states.stamp[0];
  EXPECT_TRUE(flight.hal.read(flight.now - 5 * Flight::kTick, flight.states.columns()).ok());
  EXPECT_EQ(flight.states.stamp[0], stamp);
}

TEST(LockStep, ACommandIsObeyedUntilItsDeadlineAndNoLonger) {
  Flight flight(row_of(1, Plant::kIdeal));
  const Time start = flight.now;
  ASSERT_TRUE(
      flight.hal.write(start, flight.commands.columns(start + std::chrono::milliseconds(100), 1)).ok());
  ASSERT_TRUE(flight.hal.read(start + std::chrono::seconds(1), flight.states.columns()).ok());
  EXPECT_NEAR(flight.states.x[0], 0.1F, 1e-6F);
  EXPECT_EQ(flight.states.vx[0], 0.0F);
}

TEST(LockStep, EveryRobotHasItsOwnLimits) {
  SimHalConfig config = row_of(3, Plant::kDoubleIntegrator);
  config.max_speed = {0.1F, 0.5F, 10.0F};
  config.max_acceleration = {100.0F, 100.0F, 0.2F};
  Flight flight(config);
  flight.ticks(101);
  EXPECT_NEAR(flight.states.vx[0], 0.1F, 1e-4F);
  EXPECT_NEAR(flight.states.vx[1], 0.5F, 1e-4F);
  EXPECT_NEAR(flight.states.vx[2], 0.2F, 1e-4F);
}

TEST(LockStep, TwoRunsAndTwoBackendsGiveTheSameBits) {
  std::vector<contract::States> ends;
  for (const Backend backend : {Backend::kNative, Backend::kNative, Backend::kOpenCl}) {
    SimHalConfig config = row_of(77, Plant::kVelocityLag, backend);
    config.faults.pose_noise = 0.01F;
    Flight flight(config);
    for (int tick = 0; tick < 300; ++tick) {
      for (std::size_t robot = 0; robot < 77; ++robot) {  // something that depends on what was read
        flight.commands.vy[robot] = 2.0F - flight.states.y[robot];
        flight.commands.vz[robot] = flight.states.x[robot] * 0.1F;
      }
      flight.tick();
    }
    ends.push_back(flight.states);
  }
  for (const contract::States& end : ends) {
    EXPECT_EQ(std::memcmp(end.x.data(), ends[0].x.data(), 77 * sizeof(float)), 0);
    EXPECT_EQ(std::memcmp(end.vz.data(), ends[0].vz.data(), 77 * sizeof(float)), 0);
  }
}

TEST(LockStep, WhileInactiveRobotsHoldAndTimeGoesOn) {
  Flight flight(row_of(1, Plant::kVelocityLag));
  flight.ticks(200);
  const float x = flight.hal.truth().columns[0][0];
  ASSERT_TRUE(flight.hal.deactivate(flight.now).has_value());
  flight.now += std::chrono::hours(1);
  ASSERT_TRUE(flight.hal.activate(flight.now).has_value());
  ASSERT_TRUE(flight.hal.read(flight.now, flight.states.columns()).ok());
  EXPECT_EQ(flight.states.stamp[0], flight.now);
  EXPECT_NEAR(flight.states.x[0], x + 0.11F, 0.02F);  // it ran out: a tick at 1 m/s, then τ = 0.1 s
  EXPECT_NEAR(flight.states.vx[0], 0.0F, 1e-6F);
}

TEST(Backend, IsTheOneThatWasAskedFor) {
  EXPECT_EQ(Flight(row_of(1)).hal.backend(), "native");
  Flight opencl(row_of(1, Plant::kIdeal, Backend::kOpenCl));
  EXPECT_EQ(opencl.hal.backend().substr(0, 8), "opencl: ");
  EXPECT_EQ(opencl.hal.backend_note(), "");
}

TEST(Backend, FallsBackWhereThereIsNoDeviceAndSaysSo) {
  setenv("MAYFLY_OPENCL_DEVICE", "abacus", 1);
  SimHal automatic(row_of(1, Plant::kIdeal, Backend::kAutomatic));
  SimHal strict(row_of(1, Plant::kIdeal, Backend::kOpenCl));
  EXPECT_TRUE(automatic.configure().has_value());
  EXPECT_EQ(automatic.backend(), "native");
  EXPECT_NE(automatic.backend_note().find("abacus"), std::string_view::npos);
  const auto refused = strict.configure();
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().cause, Cause::kEnvironment);
  unsetenv("MAYFLY_OPENCL_DEVICE");
}

}  // namespace
}  // namespace mayfly::sim_hal
