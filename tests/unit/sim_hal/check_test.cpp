// What no simulated HAL can be made of.
#include "sim_hal/check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "sim_hal/sim_hal.hpp"
#include "tests/contract/sim_factory.hpp"

namespace mayfly::sim_hal {
namespace {

struct Bad {
  std::string word;  // in the message
  std::function<void(SimHalConfig&)> spoil;
};

TEST(Check, AGoodOnePasses) {
  EXPECT_TRUE(check(row_of(3)).has_value());
  EXPECT_TRUE(check(row_of(0)).has_value());
}

TEST(Check, BadOnesAreRefusedWithTheReason) {
  const float nan = std::nanf("");
  const std::vector<Bad> bad{
      {"rate", [](SimHalConfig& c) { c.rate_hz = 0.0; }},
      {"rate", [](SimHalConfig& c) { c.rate_hz = 1e6; }},
      {"rate", [&](SimHalConfig& c) { c.rate_hz = static_cast<double>(nan); }},
      {"time constant", [](SimHalConfig& c) { c.time_constant = -1.0F; }},
      {"noise", [&](SimHalConfig& c) { c.faults.pose_noise = nan; }},
      {"delay", [](SimHalConfig& c) { c.faults.delay = 11.0F; }},
      {"dropout", [](SimHalConfig& c) { c.faults.dropout = 1.1F; }},
      {"freeze", [](SimHalConfig& c) { c.faults.freeze = -0.1F; }},
      {"freeze time", [](SimHalConfig& c) { c.faults.freeze_time = 61.0F; }},
      {"nan", [](SimHalConfig& c) { c.faults.nan = 2.0F; }},
      {"maximum speed", [](SimHalConfig& c) { c.max_speed = {-1.0F}; }},
      {"maximum speed",
       [](SimHalConfig& c) {
         c.max_speed = {1.0F, 2.0F};
       }},
      {"maximum acceleration",
       [&](SimHalConfig& c) {
         c.max_acceleration = {1.0F, nan, 1.0F};
       }},
      {"position", [](SimHalConfig& c) { c.positions.pop_back(); }},
      {"fly1", [&](SimHalConfig& c) { c.positions[1].y = nan; }},
      {"fly0", [](SimHalConfig& c) { c.robot_names[2] = "fly0"; }},
      {"clock", [](SimHalConfig& c) { c.lock_step = false; }},
  };
  for (const Bad& each : bad) {
    SimHalConfig config = row_of(3);
    each.spoil(config);
    SimHal hal(config);
    const auto done = hal.configure();
    ASSERT_FALSE(done.has_value()) << each.word;
    EXPECT_EQ(done.error().cause, Cause::kCaller);
    EXPECT_NE(done.error().message.find(each.word), std::string::npos) << done.error().message;
    EXPECT_EQ(hal.state(), HalState::kCreated);
  }
}

}  // namespace
}  // namespace mayfly::sim_hal
