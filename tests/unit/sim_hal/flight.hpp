// A simulated HAL in flight, for tests: always the same commands, at 100 Hz.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim_hal/sim_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/sim_factory.hpp"

namespace mayfly::sim_hal {

class Flight {
 public:
  static constexpr Time kTick = std::chrono::milliseconds(10);

  explicit Flight(const SimHalConfig& config)
      : hal(config), states(config.positions.size()), commands(config.positions.size()) {
    EXPECT_TRUE(hal.configure().has_value());
    EXPECT_TRUE(hal.activate(now).has_value());
  }
  // Reads, writes, a hundredth of a second.
  void tick() {
    EXPECT_TRUE(hal.read(now, states.columns()).ok());
    EXPECT_TRUE(hal.write(now, commands.columns(now + 10 * kTick, ++sequence)).ok());
    now += kTick;
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) {
      tick();
    }
  }

  SimHal hal;
  contract::States states;
  contract::Commands commands;
  Time now = std::chrono::seconds(5);
  std::uint64_t sequence = 0;
};

}  // namespace mayfly::sim_hal
