// Minimum distance enforcement on the places where agents will be (Wang14 §6): the part that both engines
// share. It also keeps the order in which an engine best takes the agents: near in space, near in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/engine/cell_order.hpp"
#include "controller/engine/displacements.hpp"
#include "controller/engine/engine.hpp"
#include "controller/engine/thread_team.hpp"

namespace mayfly {

// The first sweep, over all agents; each engine has its own way to run it.
class FirstSweep {
 public:
  virtual ~FirstSweep() = default;
  virtual void first_sweep(const CellOrder& order, SearchReach reach, Displacements& out) noexcept = 0;
};

class MinimumDistance {
 public:
  void prepare(std::span<const SwarmModel> swarms, std::size_t agents);

  // The agents of each swarm at the swarm's own range of slots, in the order of space as of the last tick.
  // Readable eight elements past the last.
  std::span<const int> order() const { return slots_; }
  // One a slot: where its agent will be after the period (m). An engine writes them before enforce().
  VelocityColumns ahead() { return {ahead_x_, ahead_y_, ahead_z_}; }
  // Writes them for velocities that were changed since; all in the agents' order.
  void look_ahead(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
                  ThreadTeam& team) noexcept;

  // Corrects `velocity` so that agents at `at` keep their distance after `period_s`; both in the agents'
  // order. Sweeps go on until nobody is too near or all are done. Returns how many agents were moved.
  std::size_t enforce(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
                      FirstSweep& first, ThreadTeam& team) noexcept;

 private:
  void take_order() noexcept;
  bool apply(ThreadTeam& team) noexcept;
  void correct(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
               ThreadTeam& team) noexcept;

  std::span<const SwarmModel> swarms_;
  std::size_t agents_ = 0;
  int sweeps_ = 0;
  CellLimits limits_{};
  SearchReach reach_{};
  float rounding_ = 0.0F;  // m: what a coordinate loses
  CellOrder order_;
  std::vector<int> slots_;
  std::vector<float> half_distance_;                // m, one a slot
  std::vector<float> ahead_x_, ahead_y_, ahead_z_;  // m, one a slot
  // From here on in sorted order.
  Displacements displacements_;
  std::vector<std::uint8_t> moved_, ever_moved_, marks_;
  std::vector<float> farthest_move_;  // m, one a chunk
};

}  // namespace mayfly
