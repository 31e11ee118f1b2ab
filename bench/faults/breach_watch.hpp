// Whether what is promised of a flight holds, seen from outside: of the robots' true places at every plant
// step and of what reaches their HAL. It knows nothing of the guard.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "sim_hal/config.hpp"

namespace mayfly::bench {

enum class Breach : std::uint8_t { kSeparation, kFence, kSpeed, kAcceleration, kCount };
inline constexpr std::size_t kBreaches = static_cast<std::size_t>(Breach::kCount);
using BreachCounts =
    std::array<std::uint64_t, kBreaches>;  // robot-steps (pairs, of kSeparation) and commands

// One of those that are counted.
struct Incident {
  Time at{0};
  Breach breach = Breach::kCount;
  std::uint32_t first = 0, second = 0;  // robots; the same where there was but one
};

struct PromisedLimits {
  float radius = 0.05F;       // m, of every body
  float speed = 2.0F;         // m/s
  float acceleration = 4.0F;  // m/s²
  Box fence;                  // m
};

// Of one HAL in lock step.
class BreachWatch final : public sim_hal::StepWatcher {
 public:
  BreachWatch(std::size_t robots, const PromisedLimits& limits);

  void on_step(const sim_hal::PoseView& truth) noexcept override;
  void on_command(Time now, const CommandColumns& commands) noexcept override;

  const BreachCounts& breaches() const noexcept { return breaches_; }
  const std::vector<Incident>& incidents() const noexcept { return incidents_; }
  // m: the least distance of two bodies' surfaces; infinite where there were no two.
  double least_gap() const noexcept { return least_gap_; }
  // Of all true places and commands: equal for runs that are the same bit for bit.
  std::uint64_t hash() const noexcept { return hash_; }
  // s from `at` until the robot was told to stand still, and was so for good or for half a second; empty
  // where it was not.
  std::optional<double> stopped_after(std::size_t robot, Time at) const;

 private:
  void count(Breach breach, Time at, std::size_t first, std::size_t second) noexcept;
  void mix(float value) noexcept;

  std::size_t robots_;
  PromisedLimits limits_;
  BreachCounts breaches_{};
  std::vector<Incident> incidents_;
  double least_gap_ = std::numeric_limits<double>::infinity();
  std::uint64_t hash_ = 14695981039346656037U;
  std::optional<Time> first_, last_;
  std::vector<std::array<double, 3>> told_;           // m/s, one a robot, of the last command
  std::vector<std::uint8_t> was_velocity_;            // whether it was one
  std::vector<Time> times_;                           // of every command
  std::vector<std::vector<std::uint8_t>> is_moving_;  // at each of them, one a robot
};

}  // namespace mayfly::bench
