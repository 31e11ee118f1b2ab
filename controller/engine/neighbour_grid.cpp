#include "controller/engine/neighbour_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

using kernels::F;
using kernels::F3;
using kernels::I;

constexpr std::size_t kChunk = 1024;
constexpr std::size_t kSample = 512;  // agents that the grid's extent is judged by
constexpr int kMostAlong = 1024;      // cells along an axis: see MF_CELL_MARGIN
constexpr float kThinnest = 1e-3F;    // m: of a swarm's extent
constexpr float kFarthest = 1e15F;    // m: beyond, squares of distances are no numbers

// Eight agents from `a` on; beyond `last` the first of them again, for columns that are not readable there.
F eight_of(std::span<const float> column, std::size_t a, std::size_t last) {
  if (a + MF_LANES <= last) {
    return kernels::mf_load(&column[a]);
  }
  F eight = kernels::mf_splat(column[a]);
  for (std::size_t k = a; k < last; ++k) {
    eight[k - a] = column[k];
  }
  return eight;
}

I is_place(F3 r) {
  const auto is_number = [](F a) {
    return (a < kernels::mf_splat(kFarthest)) & (a > kernels::mf_splat(-kFarthest));
  };
  return is_number(r.x) & is_number(r.y) & is_number(r.z);
}

}  // namespace

void NeighbourGrid::reserve(std::size_t first, std::size_t count) {
  first_ = first;
  most_ = count;
  count_ = eight_count_ = absent_count_ = 0;
  for (std::vector<float>& column : columns_) {
    column.assign(count + MF_LANES, 0.0F);
  }
  for (std::vector<float>& column : sample_) {
    column.assign(kSample, 0.0F);
  }
  id_.assign(count + MF_LANES, 0);
  start_.assign(most_cells(count) + 1, 0);
  eights_.assign(most_eights(count), 0);
  absent_.assign(count, 0);
  cell_of_.assign(count + MF_LANES, 0);
}

void NeighbourGrid::sort(const AgentColumns& at, float company, float least_side, ThreadTeam& team) noexcept {
  choose_cells(extent(at), company, least_side);
  name_cells(at, team);
  order_by_cell();
  copy_columns(at, team);
  cut_rows();
}

// Where most of a sample are, and half as much on either side, but no more than all need: strays share the
// outermost cells.
NeighbourGrid::Extent NeighbourGrid::extent(const AgentColumns& at) noexcept {
  const std::size_t stride = std::max<std::size_t>(most_ / kSample, 1);
  std::size_t taken = 0;
  for (std::size_t a = first_; a < first_ + most_ && taken < kSample; a += stride) {
    if (std::fabs(at.x[a]) < kFarthest && std::fabs(at.y[a]) < kFarthest && std::fabs(at.z[a]) < kFarthest) {
      sample_[0][taken] = at.x[a];
      sample_[1][taken] = at.y[a];
      sample_[2][taken] = at.z[a];
      ++taken;
    }
  }
  const std::array<std::span<const float>, 3> axes{at.x, at.y, at.z};
  Extent extent;
  for (std::size_t axis = 0; axis < 3 && taken > 0; ++axis) {
    const auto begin = sample_[axis].begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(taken);
    const auto cut = static_cast<std::ptrdiff_t>(taken / 50);
    std::nth_element(begin, begin + cut, end);
    const float low = *(begin + cut);
    std::nth_element(begin, end - 1 - cut, end);
    const float high = *(end - 1 - cut);
    const float beyond = 0.5F * (high - low);
    F least = kernels::mf_splat(low);
    F greatest = kernels::mf_splat(high);
    for (std::size_t a = first_; a < first_ + most_; a += MF_LANES) {
      const F here = eight_of(axes[axis], a, first_ + most_);  // what is no number is neither
      least = kernels::mf_min(here, least);
      greatest = kernels::mf_max(here, greatest);
    }
    extent.low[axis] = std::max(kernels::mf_least(least), low - beyond);
    extent.high[axis] = std::min(kernels::mf_greatest(greatest), high + beyond);
  }
  return extent;
}

void NeighbourGrid::choose_cells(const Extent& extent, float company, float least_side) noexcept {
  const auto most = static_cast<double>(most_cells(most_));
  const double wanted =
      std::clamp(static_cast<double>(most_) / static_cast<double>(company), 1.0, 0.5 * most);
  std::array<double, 3> length{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    length[axis] = std::max(extent.high[axis] - extent.low[axis], kThinnest);
  }
  const auto cells_along = [&](std::size_t axis, double side) {
    return std::clamp(std::ceil(length[axis] / side), 1.0, double{kMostAlong});
  };
  const auto cells = [&](double side) {
    return cells_along(0, side) * cells_along(1, side) * cells_along(2, side);
  };
  double side = std::max(std::cbrt(length[0] * length[1] * length[2] / wanted), double{least_side});
  // In thin swarms whole cells are more than their volume would give.
  while (cells(side) > 1.5 * wanted) {
    side *= 1.1;
  }
  cubes_ = {extent.low[0],
            extent.low[1],
            extent.low[2],
            static_cast<float>(1.0 / side),
            static_cast<int>(cells_along(0, side)),
            static_cast<int>(cells_along(1, side)),
            static_cast<int>(cells_along(2, side))};
}

void NeighbourGrid::name_cells(const AgentColumns& at, ThreadTeam& team) noexcept {
  const std::size_t end = first_ + most_;
  team.for_ranges(most_, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t local = first; local < last; local += MF_LANES) {
      const std::size_t a = first_ + local;
      const F3 r = kernels::mf3(eight_of(at.x, a, end), eight_of(at.y, a, end), eight_of(at.z, a, end));
      const I cell =
          kernels::mf_iselect(is_place(r), kernels::mf_cube_index(r, &cubes_), kernels::mf_isplat(-1));
      const std::size_t lanes = std::min<std::size_t>(MF_LANES, last - local);
      for (std::size_t k = 0; k < lanes; ++k) {
        cell_of_[local + k] = cell[k];
      }
    }
  });
}

// A counting sort that keeps numbers in order, on one thread: it takes a hundredth of what its order saves,
// and a sort by several threads would leave the order within cells to chance.
void NeighbourGrid::order_by_cell() noexcept {
  const std::size_t cells = cell_count();
  std::fill_n(start_.begin(), cells + 1, 0);
  absent_count_ = 0;
  for (std::size_t local = 0; local < most_; ++local) {
    if (cell_of_[local] >= 0) {
      ++start_[static_cast<std::size_t>(cell_of_[local])];
    } else {
      absent_[absent_count_++] = static_cast<int>(first_ + local);
    }
  }
  int before = 0;
  for (std::size_t c = 0; c <= cells; ++c) {
    const int here = start_[c];
    start_[c] = before;
    before += here;
  }
  count_ = most_ - absent_count_;
  for (std::size_t local = 0; local < most_; ++local) {
    if (cell_of_[local] >= 0) {
      const int slot = start_[static_cast<std::size_t>(cell_of_[local])]++;
      id_[static_cast<std::size_t>(slot)] = static_cast<int>(first_ + local);
    }
  }
  // Each start is now the next one's.
  for (std::size_t c = cells; c > 0; --c) {
    start_[c] = start_[c - 1];
  }
  start_[0] = 0;
}

void NeighbourGrid::copy_columns(const AgentColumns& at, ThreadTeam& team) noexcept {
  const std::array<std::span<const float>, 6> from{at.x, at.y, at.z, at.vx, at.vy, at.vz};
  team.for_ranges(count_, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (!from[column].empty()) {
        for (std::size_t slot = first; slot < last; ++slot) {
          columns_[column][slot] = from[column][static_cast<std::size_t>(id_[slot])];
        }
      }
    }
  });
}

void NeighbourGrid::cut_rows() noexcept {
  const auto row = static_cast<std::size_t>(cubes_.cells_x);
  eight_count_ = 0;
  for (std::size_t cell = 0; cell < cell_count(); cell += row) {
    for (int slot = start_[cell]; slot < start_[cell + row]; slot += MF_LANES) {
      eights_[eight_count_++] = slot;
    }
  }
  eights_[eight_count_] = static_cast<int>(count_);
}

}  // namespace mayfly
