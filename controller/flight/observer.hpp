// Those who watch a flight: recorders, plots, the live page. They see every tick and may not delay it.
#pragma once

#include <cstdint>
#include <span>

#include "core/clock.hpp"
#include "core/hal.hpp"

namespace mayfly {

// One control tick as it happened. Columns have one element an agent and are valid during the call only.
// Positions in m and velocities in m/s, world frame: the truth on a simulated HAL, the estimate otherwise.
struct TickView {
  std::uint64_t tick = 0;
  Time time{0};
  std::span<const float> x, y, z;
  std::span<const float> vx, vy, vz;
  std::span<const float> command_x, command_y, command_z;  // what was written to the HAL
  std::span<const CommandKind> kind;
  std::span<const std::uint8_t> valid;  // 0: the estimate rests on an old sample
  // 0: the agent has not joined yet, or has left; empty: all are there.
  std::span<const std::uint8_t> present{};

  bool is_there(std::size_t agent) const noexcept { return present.empty() || present[agent] != 0; }
};

class Observer {
 public:
  virtual ~Observer() = default;
  // Called on the control thread after the commands are written.
  virtual void on_tick(const TickView& view) noexcept = 0;
};

}  // namespace mayfly
