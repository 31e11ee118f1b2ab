// Other robots than the paper's points: what lags, what must accelerate, and both under the governor.
#include <gtest/gtest.h>

#include <cstdio>
#include <tuple>

#include "tests/sim/scenarios/flown.hpp"

namespace mayfly::test {
namespace {

TEST(InterfaceExample, IsFlownAsItExpects) {
  const Flown flown = fly(MAYFLY_SOURCE_DIR "/tests/sim/scenarios/interface_example.yaml", {});
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
  std::printf("interface example: separation %.5f m, MDE %.3f %%\n", flown.number("min_separation_m"),
              flown.number("mde_percent"));
}

class Robots : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(Robots, FlyAroundTwoBlocksUnharmed) {
  const auto& [plant, governor] = GetParam();
  const Flown flown = fly(scenario_file("two_blocks_around"),
                          {"--set", "swarms.flies.count=60", "--set", "swarms.flies.governor=" + governor,
                           "--set", "swarms.flies.limits={speed: 3, acceleration: 20, separation: 0.2}",
                           "--set", "hal.sim.plant=" + plant});
  ASSERT_LE(flown.exit_code, 1);
  expect_kept(flown);
  EXPECT_EQ(flown.number("reached_fraction"), 1.0);
  EXPECT_EQ(flown.number("penetrations"), 0);
  EXPECT_EQ(flown.number("collisions"), 0);
  EXPECT_LE(flown.number("max_speed_mps"), 3.0 * (1 + 1e-5));
  std::printf("%s, governor %s: separation %.4f m, MDE %.3f %%, %g m/s2, %g interventions\n", plant.c_str(),
              governor.c_str(), flown.number("min_separation_m"), flown.number("mde_percent"),
              flown.number("max_acceleration_mps2"), flown.number("governor_interventions"));
}

INSTANTIATE_TEST_SUITE_P(Plants, Robots,
                         ::testing::Combine(::testing::Values("ideal", "velocity_lag", "double_integrator"),
                                            ::testing::Values("off", "on")),
                         [](const auto& row) {
                           return std::get<0>(row.param) + "_governor_" + std::get<1>(row.param);
                         });

}  // namespace
}  // namespace mayfly::test
