#include "controller/engine/cell_order.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

using kernels::F;
using kernels::F3;

constexpr std::size_t kChunk = 512;

F3 place(const UnsortedAgents& agents, std::size_t a) {
  return kernels::mf3(kernels::mf_load(&agents.x[a]), kernels::mf_load(&agents.y[a]),
                      kernels::mf_load(&agents.z[a]));
}

}  // namespace

void CellOrder::reserve(std::size_t agents) {
  const std::size_t padded = agents + MF_LANES;
  for (std::vector<float>* column : {&x_, &y_, &z_, &half_distance_}) {
    column->assign(padded, 0.0F);
  }
  for (std::vector<int>* column : {&id_, &cell_of_, &rank_}) {
    column->assign(padded, 0);
  }
  start_.assign(most_starts(agents), 0);
  extents_.assign(agents / kChunk + 1, {});
  share_ = 1.0F;
}

void CellOrder::sort(const UnsortedAgents& agents, const CellLimits& limits, ThreadTeam& team) noexcept {
  choose_cells(extent(agents, limits, team), agents.count, limits.least_side);
  std::fill_n(start_.begin(), cell_count() + 1, 0);
  count(agents, team);
  add_up(agents.count);
  fill(agents, team);
}

CellOrder::Extent CellOrder::extent(const UnsortedAgents& agents, const CellLimits& limits,
                                    ThreadTeam& team) noexcept {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Extent nothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const std::size_t chunks = agents.count / kChunk + 1;
  std::fill_n(extents_.begin(), chunks, nothing);
  team.for_ranges(agents.count, kChunk, [&](std::size_t first, std::size_t last) {
    F low[3], high[3];
    std::fill_n(low, 3, kernels::mf_splat(kInfinity));
    std::fill_n(high, 3, kernels::mf_splat(-kInfinity));
    for (std::size_t a = first; a < last; a += MF_LANES) {
      const kernels::I counts = kernels::mf_lane_index() < kernels::mf_isplat(static_cast<int>(last - a));
      const F3 r = place(agents, a);
      const F axes[3] = {r.x, r.y, r.z};
      for (int axis = 0; axis < 3; ++axis) {
        // What is no number is smaller and greater than nothing.
        low[axis] = kernels::mf_select(counts & (axes[axis] < low[axis]), axes[axis], low[axis]);
        high[axis] = kernels::mf_select(counts & (axes[axis] > high[axis]), axes[axis], high[axis]);
      }
    }
    Extent& own = extents_[first / kChunk];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int lane = 0; lane < MF_LANES; ++lane) {
        own.low[axis] = std::min(own.low[axis], low[axis][lane]);
        own.high[axis] = std::max(own.high[axis], high[axis][lane]);
      }
    }
  });
  Extent whole = nothing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      whole.low[axis] = std::min(whole.low[axis], extents_[chunk].low[axis]);
      whole.high[axis] = std::max(whole.high[axis], extents_[chunk].high[axis]);
    }
    whole.low[axis] = std::clamp(whole.low[axis], limits.low[axis], limits.high[axis]);
    whole.high[axis] = std::clamp(whole.high[axis], limits.low[axis], limits.high[axis]);
  }
  return whole;
}

void CellOrder::choose_cells(const Extent& extent, std::size_t agents, float least_side) noexcept {
  constexpr float kThinnest = 1e-3F;  // m
  float side[3];
  int bits[3] = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    side[axis] = std::max(share_ * (extent.high[axis] - extent.low[axis]), kThinnest);
  }
  for (int left = static_cast<int>(std::bit_width(agents / 2)) - 1; left > 0; --left) {
    const auto longest = std::max_element(side, side + 3) - side;
    if (side[longest] < 2.0F * least_side) {
      break;
    }
    side[longest] *= 0.5F;
    ++bits[longest];
  }
  cells_ = {extent.low[0],  extent.low[1], extent.low[2], 1.0F / side[0], 1.0F / side[1],
            1.0F / side[2], bits[0],       bits[1],       bits[2]};
}

void CellOrder::count(const UnsortedAgents& agents, ThreadTeam& team) noexcept {
  const bool alone = team.size() == 1;
  team.for_ranges(agents.count, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t a = first; a < last; a += MF_LANES) {
      int cell[MF_LANES];
      kernels::mf_unpack(kernels::mf_cell_index(place(agents, a), &cells_), cell);
      const std::size_t lanes = std::min<std::size_t>(MF_LANES, last - a);
      for (std::size_t k = 0; k < lanes; ++k) {
        int& in_cell = start_[static_cast<std::size_t>(cell[k])];
        cell_of_[a + k] = cell[k];
        // A locked increment takes longer than all the rest of this loop.
        rank_[a + k] = alone ? in_cell++ : std::atomic_ref(in_cell).fetch_add(1, std::memory_order_relaxed);
      }
    }
  });
}

// From counts to the first agent of each cell. Judges the cells on the way: where agents have three times the
// company that even spreading would give, the next cells are smaller.
void CellOrder::add_up(std::size_t agents) noexcept {
  const std::size_t cells = cell_count();
  int before = 0;
  std::int64_t pairs = 0;
  for (std::size_t c = 0; c < cells; ++c) {
    const int here = start_[c];
    start_[c] = before;
    before += here;
    pairs += std::int64_t{here} * here;
  }
  start_[cells] = before;
  const auto all = static_cast<double>(std::max<std::size_t>(agents, 1));
  mean_company_ = static_cast<double>(pairs) / all;
  const double crowding = mean_company_ / (1.0 + all / static_cast<double>(cells));
  constexpr float kLeastShare = 1e-3F;
  if (crowding > 3.0) {
    share_ = std::max(share_ * 0.7F, kLeastShare);
  } else if (crowding < 1.5) {
    share_ = std::min(share_ * 1.1F, 1.0F);
  }
}

void CellOrder::fill(const UnsortedAgents& agents, ThreadTeam& team) noexcept {
  team.for_ranges(agents.count, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t a = first; a < last; ++a) {
      const auto first_there = static_cast<std::size_t>(start_[static_cast<std::size_t>(cell_of_[a])]);
      const std::size_t to = first_there + static_cast<std::size_t>(rank_[a]);
      x_[to] = agents.x[a];
      y_[to] = agents.y[a];
      z_[to] = agents.z[a];
      half_distance_[to] = agents.half_distance[a];
      id_[to] = agents.id[a];
    }
  });
}

}  // namespace mayfly
