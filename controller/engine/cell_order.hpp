// Agents sorted by the cell of a coarse grid: what a search for near neighbours reads, and an order in which
// agents that are near in space are near in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/engine/thread_team.hpp"
#include "kernels/mde.h"

namespace mayfly {

// Agents in any order; columns are readable eight elements past the last agent.
struct UnsortedAgents {
  std::span<const float> x, y, z;        // m
  std::span<const float> half_distance;  // m
  std::span<const int> id;
  std::size_t count = 0;
};

// Where cells are worth having: agents outside share those inside.
struct CellLimits {
  std::array<float, 3> low{}, high{};  // m
  float least_side = 0.0F;             // m: no cell is made smaller
};

class CellOrder {
 public:
  // How long start() is at the most.
  static std::size_t most_starts(std::size_t agents) { return agents + 2; }

  // Room for `agents`; nothing allocates afterwards.
  void reserve(std::size_t agents);

  // Sorts by counting. The order of agents that share a cell is not defined. Cells hold about two agents on
  // average; where a swarm crowds together in a part of its bounding box they become smaller from call to
  // call.
  void sort(const UnsortedAgents& agents, const CellLimits& limits, ThreadTeam& team) noexcept;

  const kernels::MfCells& cells() const { return cells_; }
  std::size_t cell_count() const {
    return std::size_t{1} << static_cast<unsigned>(cells_.bits_x + cells_.bits_y + cells_.bits_z);
  }
  kernels::MfSorted sorted() const {
    return {start_.data(), x_.data(), y_.data(), z_.data(), half_distance_.data(), id_.data()};
  }
  // Sorted columns, readable eight elements past the last agent. Places may be changed; cells do not follow.
  std::span<float> x() { return x_; }
  std::span<float> y() { return y_; }
  std::span<float> z() { return z_; }
  std::span<const float> x() const { return x_; }
  std::span<const float> y() const { return y_; }
  std::span<const float> z() const { return z_; }
  std::span<const float> half_distance() const { return half_distance_; }
  std::span<const int> id() const { return id_; }        // the agent's number before sorting
  std::span<const int> start() const { return start_; }  // one a cell, and one past the last
  // How many agents share the cell of an agent, itself included, on average.
  double mean_company() const { return mean_company_; }

 private:
  struct Extent {
    std::array<float, 3> low, high;
  };

  Extent extent(const UnsortedAgents& agents, const CellLimits& limits, ThreadTeam& team) noexcept;
  void choose_cells(const Extent& extent, std::size_t agents, float least_side) noexcept;
  void count(const UnsortedAgents& agents, ThreadTeam& team) noexcept;
  void add_up(std::size_t agents) noexcept;
  void fill(const UnsortedAgents& agents, ThreadTeam& team) noexcept;

  kernels::MfCells cells_{};
  std::vector<float> x_, y_, z_, half_distance_;
  std::vector<int> id_;
  std::vector<int> start_;
  std::vector<int> cell_of_, rank_;  // of each unsorted agent: its cell, and its place there
  std::vector<Extent> extents_;      // one a chunk
  float share_ = 1.0F;               // of the bounding box's sides that the cells cover before they repeat
  double mean_company_ = 0.0;
};

}  // namespace mayfly
