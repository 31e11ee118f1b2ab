// What the governor keeps, and what it counts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "controller/governor/obstacle_view.hpp"
#include "core/clock.hpp"
#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly {

// How a robot's velocity gets to a new command.
enum class Follows : std::uint8_t {
  kAccelerating,  // straight towards it, at the acceleration limit
  kAtOnce,
};

struct GovernorLimits {
  float speed = 3.0F;          // m/s
  float acceleration = 20.0F;  // m/s²
  float braking = 20.0F;       // m/s², at most `acceleration`
  float radius = 0.05F;        // m, the body
  // By how much the true place may differ from the one that is governed: pose noise, tracking error
  // (docs/explanation/safety.md's ε), m. 0: nothing is promised of it and nothing judged, and the reference
  // goes wherever the robot is.
  float tube = 0.0F;
  // Of a robot that answers velocity commands as a first-order lag, s; 0 for one that does not. Its velocity
  // is (g − p)/τ then, of a point g that moves exactly as commanded.
  float response_time = 0.0F;
  Follows follows = Follows::kAccelerating;  // where response_time is 0
  int latency = 0;  // ticks, at most kMostLatency: a command takes effect after 0 to this many
  // s that a robot flies on by itself when the next command does not come, before it brakes; that long at
  // least, if a command's life is longer.
  float watchdog = 0.0F;
  float downwash = 1.0F;  // two of these keep this many times the distance above each other; at least 1
};
inline constexpr int kMostLatency = 8;

// A swarm: agents [first, first + count).
struct GovernorGroup {
  std::size_t first = 0;
  std::size_t count = 0;
  GovernorLimits limits;
  // False: only finite checks, state checks and the speed limit stay (`governor: off`); the others take no
  // notice of them.
  bool enabled = true;
  float separation = 0.0F;  // m between two centres, as the planner keeps it; 0: it was not told
};

// The side of a plane on which robots stay: normal · x <= offset. Unit normal; m.
struct HalfSpace {
  glm::vec3 normal{0.0F, 0.0F, 1.0F};
  float offset = 0.0F;
};

struct GovernorConfig {
  Time period{0};  // of the control task
  // What is sent is obeyed for so long, then the robot brakes by itself. 0: for a period.
  Time command_life{0};
  Box fence;                           // m; bodies stay inside
  std::vector<HalfSpace> half_spaces;  // and in all of these
  ObstacleView obstacles;              // empty for none
  std::vector<GovernorGroup> groups;   // cover the agents without gap or overlap, in order
};

// Refuses limits that are not finite or not positive, a fence that has no room for a body or is smaller than
// a stopping distance, a separation below two radii and tubes or below what a robot flies on unheard, groups
// that do not cover the agents; with the inequality and its numbers.
Result<void> check(const GovernorConfig& config);

// Why a command was changed.
enum class GovernorReason : std::uint8_t {
  kNotFinite,  // the desired velocity was not a number: taken for "no command"
  kUnknown,    // nobody knows where the robot is
  kOrdered,    // its authority does not allow it to move
  kSpeed,
  kAcceleration,
  kFence,
  kNeighbour,
  kObstacle,
};
inline constexpr std::size_t kGovernorReasons = 8;

struct GovernorCounters {
  std::uint64_t ticks = 0;
  std::uint64_t skipped_ticks = 0;  // periods in which nobody called
  std::uint64_t interventions = 0;  // agent-ticks in which the command was changed by more than rounding
  // Agent-ticks by reason; one may have several (too fast and too sudden).
  std::array<std::uint64_t, kGovernorReasons> by_reason{};
  std::uint64_t nudges = 0;         // agent-ticks in which a reference was moved to where its robot is
  std::uint64_t refused_calls = 0;  // columns shorter than the number of agents: every robot was told to hold

  std::uint64_t of(GovernorReason reason) const { return by_reason[static_cast<std::size_t>(reason)]; }
};

}  // namespace mayfly
