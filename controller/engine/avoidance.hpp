// Collision avoidance among all agents of all swarms (kernels/orca.h): the part that both engines share. It
// stands between what swarms prefer and minimum distance enforcement.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/engine/near_grid.hpp"
#include "controller/engine/nearest.hpp"
#include "controller/engine/thread_team.hpp"
#include "kernels/orca.h"

namespace mayfly {

class Avoidance {
 public:
  void prepare(std::span<const SwarmModel> swarms, std::size_t agents, std::size_t threads);
  // Whether any swarm avoids collisions.
  bool on() const { return most_ > 0; }

  // Sorts the agents and finds the neighbours of those that avoid collisions.
  void look_round(const AgentColumns& at, ThreadTeam& team) noexcept;

  // What look_round() saw. Columns are as long as there are agents, and some more.
  std::size_t present() const { return grid_.size(); }
  kernels::MfMinded minded() const {
    return {body_.data(), motion_.data(), grid_.id().data(), nearest_.data(), kMostNearest};
  }
  std::span<const float> body() const { return body_; }
  std::span<const float> motion() const { return motion_; }
  std::span<const int> id() const { return grid_.id(); }
  std::span<const int> nearest() const { return nearest_; }
  std::span<const int> slots() const { return slots_; }
  // A swarm's part of slots(), readable eight elements past its last; empty where it does not avoid
  // collisions.
  std::span<const int> slots_of(std::size_t swarm) const {
    return std::span(slots_).subspan(first_slot(swarm), slots_in_[swarm]);
  }
  std::size_t first_slot(std::size_t swarm) const { return swarms_[swarm].first; }
  std::size_t swarms() const { return swarms_.size(); }

 private:
  void sort(const AgentColumns& at, ThreadTeam& team) noexcept;
  void take_bodies(const AgentColumns& at, ThreadTeam& team) noexcept;
  void take_slots() noexcept;
  void find_neighbours(const AgentColumns& at, ThreadTeam& team) noexcept;
  std::span<int, kMostNearest> nearest_of(std::size_t slot) noexcept {
    return std::span(nearest_).subspan(slot * kMostNearest).first<kMostNearest>();
  }
  void find_far_ones(std::size_t slot, const NearestQuery& query) noexcept;

  std::span<const SwarmModel> swarms_;
  float range_ = 0.0F;  // m, the longest
  int most_ = 0;        // neighbours, of any swarm
  float side_ = 0.0F;   // m, of the next cells; 0 before the first tick
  NearGrid grid_;
  NearGrid wide_;                            // of cells as long as the range, for those outside a crowd
  std::vector<std::uint16_t> swarm_of_;      // one an agent
  std::vector<int> slot_of_, wide_slot_of_;  // one an agent, where the wide grid is in use
  std::vector<float> body_, motion_;         // four a sorted agent
  std::vector<int> nearest_;                 // kMostNearest a sorted agent
  std::vector<int> slots_;                   // sorted numbers, swarm by swarm
  std::vector<std::size_t> slots_in_;        // one a swarm
};

}  // namespace mayfly
