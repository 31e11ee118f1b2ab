// A world like that of Wang14's locusts, made without scenario files: 120×55×50 m in cells of 1 m, a village
// of boxes, cylinders and spheres, a goal at its far end.
#pragma once

#include <cstddef>
#include <vector>

#include "controller/engine/engine.hpp"
#include "core/grid.hpp"

namespace mayfly::bench {

struct AgentColumns {
  std::vector<float> x, y, z;  // m or m/s
};

class LocustWorld {
 public:
  // Ends the program with a message where the fields cannot be built.
  explicit LocustWorld(int threads);

  // `agents` at random places of the free space, the same each time.
  AgentColumns scatter(std::size_t agents) const;
  // One swarm of them, Wang14's parameters: noise scale 0.6 m and gain 1, 8 m/s. It keeps a distance at which
  // some 0.7 % are too near to somebody each tick, whatever their number. The model's spans are the world's.
  SwarmModel swarm(std::size_t agents);

  const Grid& grid() const { return grid_; }
  const std::vector<float>& distance() const { return distance_; }  // m, one a cell

 private:
  Grid grid_;
  std::vector<float> distance_, walls_, guide_;
  AgentColumns rest_;
};

// What a tick cost, on the mean of those flown.
struct TickCost {
  double seconds = 0.0;
  double cpu_seconds = 0.0;  // of all threads, waiting for each other included
  double moved_share = 0.0;  // of the agents, by minimum distance enforcement
};

// Flies `agents` at 100 Hz: compute() and integration of the places, `ticks` of them after as many that are
// not timed. The least of `runs` means counts, for others may be at work on the machine.
TickCost time_ticks(Engine& engine, LocustWorld& world, std::size_t agents, int ticks, int runs);

}  // namespace mayfly::bench
