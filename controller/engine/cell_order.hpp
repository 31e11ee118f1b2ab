// Agents sorted by the cell of a coarse grid: what a search for near neighbours reads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "kernels/mde.h"

namespace mayfly {

class CellOrder {
 public:
  // The most cells that a grid for `agents` has: more cost more to clear than they save in candidates.
  static std::size_t most_cells(std::size_t agents) { return 2 * agents + 1; }

  // Room for `agents`; nothing allocates afterwards.
  void reserve(std::size_t agents);

  // Sorts by counting, stable in the agents' index. Cells are cubes of side `least_cell` or more: as many as
  // there are agents, or fewer. half_distance: one an agent. Positions that are not numbers land in a border
  // cell.
  void sort(const PositionColumns& at, std::span<const float> half_distance, float least_cell) noexcept;

  const kernels::MfCells& cells() const { return cells_; }
  // Sorted columns, readable eight elements past the last agent.
  std::span<const float> x() const { return x_; }
  std::span<const float> y() const { return y_; }
  std::span<const float> z() const { return z_; }
  std::span<const float> half_distance() const { return half_distance_; }
  std::span<const int> id() const { return id_; }        // the agent's index before sorting
  std::span<const int> start() const { return start_; }  // one a cell, and one past the last

  kernels::MfBody body(std::size_t sorted) const {
    return {x_[sorted], y_[sorted], z_[sorted], half_distance_[sorted], id_[sorted]};
  }

 private:
  void choose_cells(const PositionColumns& at, float least_cell) noexcept;

  kernels::MfCells cells_{};
  std::vector<float> x_, y_, z_, half_distance_;
  std::vector<int> id_;
  std::vector<int> start_;
  std::vector<int> cell_of_;
};

}  // namespace mayfly
