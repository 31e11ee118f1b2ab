// How long an engine takes for a tick.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"

namespace mayfly::bench {

// Who flies, and from where.
struct Flock {
  std::span<const SwarmModel> swarms;
  std::span<const glm::vec3> places;        // m, one an agent
  std::span<const glm::vec3> velocities{};  // m/s; empty: at rest
  float period_s = 0.01F;
};

struct Ticks {
  double seconds = 0.0;  // the lower quartile of the ticks: compute(), and positions moved on by what it gave
  double moved = 0.0;    // share of the agents that minimum distance enforcement moved, mean
  double infeasible = 0.0;  // share of the agents that no velocity kept clear of everybody, mean
};

// Prepares the engine for the flock and flies it from its start.
Result<Ticks> time_ticks(Engine& engine, const Flock& flock, int ticks);

// Prepares the engine and flies the flock for `ticks`; `told` sees what every agent was told at each, m/s.
Result<void> fly(Engine& engine, const Flock& flock, int ticks,
                 const std::function<void(const std::vector<glm::vec3>& velocities)>& told);

// What the engine tells every agent at the first tick, m/s.
Result<std::vector<glm::vec3>> first_velocities(Engine& engine, const Flock& flock);

}  // namespace mayfly::bench
