// How long an engine takes for a tick.
#pragma once

#include "bench/fields/village.hpp"
#include "controller/engine/engine.hpp"

namespace mayfly::bench {

struct Ticks {
  double seconds = 0.0;  // the lower quartile of the ticks: compute(), and positions moved on by what it gave
  double moved = 0.0;    // share of the agents that minimum distance enforcement moved, mean
};

// Prepares the engine for the village and flies it from its start.
Result<Ticks> time_ticks(Engine& engine, const Village& village, int ticks);

}  // namespace mayfly::bench
