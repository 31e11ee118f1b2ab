// What the governor keeps, and what it counts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "controller/governor/obstacle_view.hpp"
#include "core/clock.hpp"
#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly {

struct GovernorLimits {
  float speed = 3.0F;          // m/s
  float acceleration = 20.0F;  // m/s²
  float braking = 20.0F;       // m/s², at most `acceleration`
  float radius = 0.05F;        // m, the body
  // By how much the true place may differ from the one that is governed: pose noise, tracking error
  // (safety.md's ε). m
  float tube = 0.0F;
  // Of a robot that answers velocity commands as a first-order lag, s; 0 for one that follows at once or is
  // limited in acceleration. What is governed then is p + τ·v, which the commanded velocity moves exactly; p
  // trails it.
  float response_time = 0.0F;
};

// A swarm: agents [first, first + count).
struct GovernorGroup {
  std::size_t first = 0;
  std::size_t count = 0;
  GovernorLimits limits;
  bool enabled = true;  // false: only finite checks, state checks and the speed limit stay (`governor: off`)
};

struct GovernorConfig {
  Time period{0};                     // of the control task
  Time max_state_age{0};              // older states count as stale
  Box fence;                          // m; bodies stay inside
  ObstacleView obstacles;             // empty for none
  std::vector<GovernorGroup> groups;  // cover the agents without gap or overlap, in order
};

// Refuses limits that are not finite or not positive, a fence that has no room for a body, groups that do not
// cover the agents, with the inequality and its numbers.
Result<void> check(const GovernorConfig& config);

// Why a command was changed.
enum class GovernorReason : std::uint8_t {
  kNotFinite,     // the desired velocity was not a number: taken for "no command"
  kInvalidState,  // the robot's state is not valid, or not finite
  kStaleState,    // it is older than the age limit, or as far in the future
  kSpeed,
  kAcceleration,
  kFence,
  kObstacle,
};
inline constexpr std::size_t kGovernorReasons = 7;

struct GovernorCounters {
  std::uint64_t ticks = 0;
  std::uint64_t interventions = 0;  // agent-ticks in which the command was changed by more than rounding
  // Agent-ticks by reason; one may have several (too fast and too sudden).
  std::array<std::uint64_t, kGovernorReasons> by_reason{};
  std::uint64_t refused_calls = 0;  // columns shorter than the number of agents: every robot was told to hold

  std::uint64_t of(GovernorReason reason) const { return by_reason[static_cast<std::size_t>(reason)]; }
};

}  // namespace mayfly
