// When robots were told to stop, and whether two flights are the same: of what reaches their HAL and of their
// true places.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulate/breach_watch.hpp"

namespace mayfly::bench {

// Of one HAL in lock step.
class CommandWatch final : public sim_hal::StepWatcher {
 public:
  // `acceleration`: m/s², what robots can do. Room is taken for `ticks`: a tick that is watched allocates
  // nothing.
  CommandWatch(std::size_t robots, std::size_t ticks, double acceleration, simulate::BreachWatch& breaches);

  // Passes both on to the watch of breaches.
  void on_step(const sim_hal::PoseView& truth) noexcept override;
  void on_command(Time now, const CommandColumns& commands) noexcept override;

  // Of all true places and commands: equal for runs that are the same bit for bit.
  std::uint64_t hash() const noexcept { return hash_; }
  // s from `at` until the robot was told to stand still, and was so for good or for half a second; empty
  // where it was not.
  std::optional<double> stopped_after(std::size_t robot, Time at) const;
  // How many commands after the first at or after `at` it was told what is safe: to slow down or to be slow,
  // to hold, land or stop. 0: with that one; empty: never.
  std::optional<std::uint64_t> safe_after(std::size_t robot, Time at) const;

 private:
  bool is(const std::vector<std::uint8_t>& flags, std::size_t tick, std::size_t robot) const {
    return flags[tick * robots_ + robot] != 0;
  }
  void mix(float value) noexcept;

  std::size_t robots_;
  double acceleration_;
  simulate::BreachWatch& breaches_;
  std::uint64_t hash_ = 14695981039346656037U;
  std::vector<double> speeds_;                 // m/s, told last
  std::vector<Time> times_;                    // of every command
  std::vector<std::uint8_t> moves_, is_safe_;  // at each of them, one a robot
};

}  // namespace mayfly::bench
