// What the base class does when a HAL's own part fails, and what reaches the robots.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/hal_contract.hpp"
#include "tests/contract/scripted_hal.hpp"

namespace mayfly::contract {
namespace {

constexpr Time kNow = std::chrono::seconds(1);

TEST(LifeCycle, AFailedConfigureMayBeTriedAgain) {
  ScriptedHal hal(1);
  hal.configure_fails = true;
  EXPECT_FALSE(hal.configure().has_value());
  EXPECT_EQ(hal.state(), HalState::kCreated);
  EXPECT_EQ(hal.counters().refused_calls, 0U);  // it was called in order; the device said no
  hal.configure_fails = false;
  EXPECT_TRUE(hal.configure().has_value());
  EXPECT_EQ(hal.configured, 2);
}

TEST(LifeCycle, AFailedActivateLeavesRobotsAlone) {
  ScriptedHal hal(1);
  ASSERT_TRUE(hal.configure().has_value());
  hal.activate_fails = true;
  EXPECT_FALSE(hal.activate(kNow).has_value());
  EXPECT_EQ(hal.state(), HalState::kConfigured);
  States states(1);
  EXPECT_EQ(hal.read(kNow, states.columns()).fault, HalFault::kWrongState);
  EXPECT_EQ(hal.reads, 0);
}

TEST(LifeCycle, AFailedDeactivateMayBeTriedAgain) {
  ScriptedHal hal(1);
  ASSERT_TRUE(hal.configure().has_value());
  ASSERT_TRUE(hal.activate(kNow).has_value());
  hal.deactivate_fails = true;
  EXPECT_FALSE(hal.deactivate(kNow).has_value());
  EXPECT_EQ(hal.state(), HalState::kActive);  // robots may still fly, so they may still be commanded
  hal.deactivate_fails = false;
  EXPECT_TRUE(hal.deactivate(kNow).has_value());
  EXPECT_TRUE(hal.deactivate(kNow).has_value());
  EXPECT_EQ(hal.deactivated, 2);
}

TEST(LifeCycle, WhatTheDeviceSaysOutranksWhatWasMended) {
  ScriptedHal hal(2);
  ASSERT_TRUE(hal.configure().has_value());
  ASSERT_TRUE(hal.activate(kNow).has_value());
  Commands commands(2);
  commands.vy[1] = std::nanf("");
  HalResult result = hal.write(kNow, commands.columns(kNow, 1));
  EXPECT_EQ(result.fault, HalFault::kNotFinite);
  EXPECT_EQ(result.robot, 1U);
  EXPECT_EQ(result.link, "wire");
  EXPECT_EQ(hal.last_kinds[0], CommandKind::kVelocity);
  EXPECT_EQ(hal.last_kinds[1], CommandKind::kHold);
  hal.write_result = {HalFault::kLinkDown, kEveryRobot, "wire", "cut"};
  result = hal.write(kNow, commands.columns(kNow, 2));
  EXPECT_EQ(result.fault, HalFault::kLinkDown);
  EXPECT_EQ(hal.counters().refused_commands, 2U);
}

TEST(LifeCycle, AnExpiredCommandReachesTheRobotsAsHold) {
  ScriptedHal hal(2);
  ASSERT_TRUE(hal.configure().has_value());
  ASSERT_TRUE(hal.activate(kNow).has_value());
  const Commands commands(5, CommandKind::kLand);
  EXPECT_TRUE(hal.write(kNow, commands.columns(kNow, 1)).ok());  // its last nanosecond
  EXPECT_EQ(hal.last_kinds[0], CommandKind::kLand);
  EXPECT_EQ(hal.last_size, 2U);
  EXPECT_EQ(hal.write(kNow + Time(1), commands.columns(kNow, 2)).fault, HalFault::kExpired);
  EXPECT_EQ(hal.last_kinds[0], CommandKind::kHold);
  EXPECT_EQ(hal.last_kinds[1], CommandKind::kHold);
  EXPECT_EQ(hal.writes, 2);
}

TEST(LifeCycle, CommandsOutOfSequenceReachNoRobot) {
  ScriptedHal hal(2);
  ASSERT_TRUE(hal.configure().has_value());
  ASSERT_TRUE(hal.activate(kNow).has_value());
  const Commands commands(2);
  EXPECT_TRUE(hal.write(kNow, commands.columns(kNow, 5)).ok());
  EXPECT_EQ(hal.write(kNow, commands.columns(kNow, 5)).fault, HalFault::kOutOfSequence);
  EXPECT_EQ(hal.writes, 1);
  ASSERT_TRUE(hal.deactivate(kNow).has_value());
  ASSERT_TRUE(hal.activate(kNow).has_value());
  EXPECT_TRUE(hal.write(kNow, commands.columns(kNow, 1)).ok());
}

}  // namespace
}  // namespace mayfly::contract
