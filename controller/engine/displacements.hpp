// Sweeps of minimum distance enforcement over agents sorted by cell (Wang14 §6; kernels/mde.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/engine/cell_order.hpp"
#include "controller/engine/thread_team.hpp"

namespace mayfly {

// How far a search has to look.
struct SearchReach {
  float farthest = 0.0F;  // m: the largest half distance of any agent
  float slack = 0.0F;     // m: how far any agent may be from where it was sorted, and what rounding takes
};

// Of one sweep, in sorted order.
struct Displacements {
  std::vector<float> x, y, z;        // m, valid where `pushed`
  std::vector<std::uint8_t> pushed;  // somebody is too near
  void resize(std::size_t agents);   // and eight more
};

// Displaces every agent.
void displace_all(const CellOrder& order, std::size_t agents, SearchReach reach, Displacements& out,
                  ThreadTeam& team) noexcept;
// Displaces those with a mark, and clears it; `pushed` becomes 0 for all others.
void displace_marked(const CellOrder& order, std::size_t agents, SearchReach reach,
                     std::span<std::uint8_t> marks, Displacements& out, ThreadTeam& team) noexcept;
// Marks each agent that `moved`, and those it is too near to; only where there are any.
void mark_neighbours(const CellOrder& order, std::size_t agents, SearchReach reach,
                     std::span<const std::uint8_t> moved, std::span<std::uint8_t> marks,
                     ThreadTeam& team) noexcept;

}  // namespace mayfly
