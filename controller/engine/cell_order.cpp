#include "controller/engine/cell_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace mayfly {
namespace {

std::pair<float, float> extent(std::span<const float> column) {
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const float value : column) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return low <= high ? std::pair{low, high} : std::pair{0.0F, 0.0F};
}

int cells_along(float length, float cell) {
  constexpr float kMost = 1 << 20;
  return static_cast<int>(std::min(length / cell, kMost)) + 1;
}

}  // namespace

void CellOrder::reserve(std::size_t agents) {
  const std::size_t padded = agents + MF_LANES;
  for (std::vector<float>* column : {&x_, &y_, &z_, &half_distance_}) {
    column->assign(padded, 0.0F);
  }
  id_.assign(padded, -1);
  cell_of_.assign(agents, 0);
  start_.assign(most_cells(agents) + 1, 0);
}

void CellOrder::choose_cells(const PositionColumns& at, float least_cell) noexcept {
  const auto [x0, x1] = extent(at.x);
  const auto [y0, y1] = extent(at.y);
  const auto [z0, z1] = extent(at.z);
  const auto room = static_cast<std::int64_t>(most_cells(at.x.size()));
  float cell = std::max(least_cell, 1e-3F);
  for (;;) {
    cells_.nx = cells_along(x1 - x0, cell);
    cells_.ny = cells_along(y1 - y0, cell);
    cells_.nz = cells_along(z1 - z0, cell);
    // In steps, for the product of three may not fit into 64 bits.
    const std::int64_t plane = std::int64_t{cells_.nx} * cells_.ny;
    if (plane <= room && plane * cells_.nz <= room) {
      break;
    }
    cell *= 1.25F;
  }
  cells_.origin_x = x0;
  cells_.origin_y = y0;
  cells_.origin_z = z0;
  cells_.inverse_cell = 1.0F / cell;
}

void CellOrder::sort(const PositionColumns& at, std::span<const float> half_distance,
                     float least_cell) noexcept {
  const std::size_t agents = at.x.size();
  choose_cells(at, least_cell);
  const std::size_t cells = static_cast<std::size_t>(cells_.nx) * static_cast<std::size_t>(cells_.ny) *
                            static_cast<std::size_t>(cells_.nz);
  std::fill_n(start_.begin(), cells + 1, 0);
  for (std::size_t a = 0; a < agents; ++a) {
    const int cx = kernels::mf_cell_of(at.x[a], cells_.origin_x, cells_.inverse_cell, cells_.nx);
    const int cy = kernels::mf_cell_of(at.y[a], cells_.origin_y, cells_.inverse_cell, cells_.ny);
    const int cz = kernels::mf_cell_of(at.z[a], cells_.origin_z, cells_.inverse_cell, cells_.nz);
    cell_of_[a] = (cz * cells_.ny + cy) * cells_.nx + cx;
    ++start_[static_cast<std::size_t>(cell_of_[a]) + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) {
    start_[c + 1] += start_[c];
  }
  // Fill from the back of each cell's range, which leaves start_[c + 1] at the cell's first agent: shift by
  // one below.
  for (std::size_t a = agents; a-- > 0;) {
    const auto sorted = static_cast<std::size_t>(--start_[static_cast<std::size_t>(cell_of_[a]) + 1]);
    x_[sorted] = at.x[a];
    y_[sorted] = at.y[a];
    z_[sorted] = at.z[a];
    half_distance_[sorted] = half_distance[a];
    id_[sorted] = static_cast<int>(a);
  }
  std::copy_n(start_.begin() + 1, cells, start_.begin());
  start_[cells] = static_cast<int>(agents);
}

}  // namespace mayfly
