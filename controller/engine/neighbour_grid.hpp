// A swarm sorted by the cells of a grid, made anew each tick: what a search for neighbours within a wide
// reach reads. The same places give the same order, whatever came before, so that float sums over neighbours
// have the same bits on any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/engine/thread_team.hpp"
#include "kernels/neighbours.h"

namespace mayfly {

class NeighbourGrid {
 public:
  // Room for the agents `first` … first + count − 1 of a flight; nothing allocates afterwards.
  void reserve(std::size_t first, std::size_t count);

  // Sorts them by cells, those of a cell by number. Agents whose place is not finite are left out. Cells hold
  // about `company` agents where they are evenly spread, but none is smaller than `least_side` (m).
  void sort(const AgentColumns& at, float company, float least_side, ThreadTeam& team) noexcept;

  // How many are sorted.
  std::size_t count() const { return count_; }
  const kernels::MfCubes& cubes() const { return cubes_; }
  std::size_t cell_count() const {
    return static_cast<std::size_t>(cubes_.cells_x) * static_cast<std::size_t>(cubes_.cells_y) *
           static_cast<std::size_t>(cubes_.cells_z);
  }
  static std::size_t most_cells(std::size_t agents) { return agents / 2 + 64; }
  static std::size_t most_eights(std::size_t agents) { return agents + 1; }

  kernels::MfNeighbours neighbours() const {
    return {start_.data(),      columns_[0].data(), columns_[1].data(), columns_[2].data(),
            columns_[3].data(), columns_[4].data(), columns_[5].data()};
  }
  // x, y, z, vx, vy, vz, sorted; readable eight elements past the last agent.
  std::span<const float> column(std::size_t which) const { return columns_[which]; }
  std::span<const int> start() const { return std::span(start_).first(cell_count() + 1); }
  std::span<const int> id() const { return id_; }  // numbers in the flight
  // The first of each up to eight agents that follow each other in one row of cells; and how many there are
  // in all.
  std::span<const int> eights() const { return std::span(eights_).first(eight_count_ + 1); }
  std::size_t eight_count() const { return eight_count_; }
  // Agents that are not finite in place, by number.
  std::span<const int> absent() const { return std::span(absent_).first(absent_count_); }

 private:
  struct Extent {
    std::array<float, 3> low{}, high{};  // m
  };

  Extent extent(const AgentColumns& at) noexcept;
  void choose_cells(const Extent& extent, float company, float least_side) noexcept;
  void name_cells(const AgentColumns& at, ThreadTeam& team) noexcept;
  void order_by_cell() noexcept;
  void copy_columns(const AgentColumns& at, ThreadTeam& team) noexcept;
  void cut_rows() noexcept;

  std::size_t first_ = 0, most_ = 0, count_ = 0, eight_count_ = 0, absent_count_ = 0;
  kernels::MfCubes cubes_{};
  std::array<std::vector<float>, 6> columns_;
  std::array<std::vector<float>, 3> sample_;
  std::vector<int> id_, start_, eights_, absent_;
  std::vector<int> cell_of_;  // of each agent in its own order; −1: absent
};

}  // namespace mayfly
