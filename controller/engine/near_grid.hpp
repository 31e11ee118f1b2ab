// Points sorted by the cells of a cubic grid, for searches within a radius.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/engine/thread_team.hpp"
#include "kernels/mde.h"

namespace mayfly {

// Sorted points that lie one after the other.
struct NearRow {
  int first, past;
};

class NearGrid {
 public:
  // Room for `points`, sorted by at most `threads`; nothing allocates afterwards.
  void reserve(std::size_t points, std::size_t threads);

  // Sorts the points that have a place by cells of `side` (m). Within a cell they keep their order, on any
  // number of threads. Cells repeat in space where there are more than twice as many as points.
  void sort(const PositionColumns& at, float side, ThreadTeam& team) noexcept;

  std::size_t size() const { return size_; }  // of those with a place
  // Sorted, and readable eight elements past the last.
  std::span<const float> x() const { return x_; }
  std::span<const float> y() const { return y_; }
  std::span<const float> z() const { return z_; }
  std::span<const int> id() const { return id_; }      // which point it was
  std::span<const int> cell() const { return cell_; }  // the cell it is in
  // How many points share the cell of a point, itself included, on average.
  double mean_company() const { return mean_company_; }
  // m: searches in the cells around a point's own see all that is nearer.
  float side() const { return side_; }
  // m: the least and the greatest place along each axis; nothing is known of an empty grid.
  std::array<float, 3> low() const { return low_; }
  std::array<float, 3> high() const { return high_; }

  // The rows of points in the cells around that of sorted point `slot`, as far as `radius` (m) reaches.
  // Calls row(first, past) for each; every point within the radius is in exactly one.
  template <class Row>
  void for_rows(std::size_t slot, float radius, Row&& row) const {
    const int reach = radius <= side_ ? 1 : static_cast<int>(std::min(radius / side_, 1e6F)) + 1;
    const auto cell = static_cast<unsigned>(cell_[slot]);
    const auto [x, past_x] = along(cell, 0, reach);
    const auto [y, past_y] = along(cell >> bits_[0], 1, reach);
    const auto [z, past_z] = along(cell >> (bits_[0] + bits_[1]), 2, reach);
    const int cells_x = 1 << bits_[0];
    for (int k = z; k < past_z; ++k) {
      const int plane = (k & mask(2)) << bits_[1];
      for (int j = y; j < past_y; ++j) {
        const int* start = start_.data() + ((plane | (j & mask(1))) << bits_[0]);
        row(start[x], start[std::min(past_x, cells_x)]);
        if (past_x > cells_x) {
          row(start[0], start[past_x - cells_x]);
        }
      }
    }
  }

 private:
  struct Extent {
    std::array<float, 3> low, high;
  };

  int mask(std::size_t axis) const { return (1 << bits_[axis]) - 1; }
  // First and past-last cell along an axis; past the last of the grid they start again.
  std::pair<int, int> along(unsigned cell, std::size_t axis, int reach) const {
    const int last = mask(axis);
    const int here = static_cast<int>(cell) & last;
    if (2 * reach >= last) {
      return {0, last + 1};
    }
    const int first = (here - reach) & last;
    return {first, first + 2 * reach + 1};
  }

  void measure(const PositionColumns& at, ThreadTeam& team) noexcept;
  void choose_cells(float side, std::size_t points) noexcept;
  void count(const PositionColumns& at, ThreadTeam& team) noexcept;
  void add_up() noexcept;
  void fill(const PositionColumns& at, ThreadTeam& team) noexcept;

  kernels::MfCells cells_{};
  std::array<int, 3> bits_{};
  float side_ = 1.0F;
  std::array<float, 3> low_{}, high_{};
  std::size_t size_ = 0;
  std::size_t parts_ = 1;
  std::vector<float> x_, y_, z_;
  std::vector<int> id_, cell_;
  std::vector<int> start_;       // one a cell, and one past the last
  std::vector<int> cell_of_;     // one a point, in the order they came
  std::vector<int> next_;        // one a part of the points and a cell: where the next one goes
  std::vector<Extent> extents_;  // one a part
  double mean_company_ = 0.0;
};

}  // namespace mayfly
