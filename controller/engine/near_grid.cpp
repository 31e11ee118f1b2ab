#include "controller/engine/near_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

constexpr int kFewestBits = 6;
constexpr std::size_t kGrain = 4096;

int most_bits(std::size_t points) {
  return std::max(static_cast<int>(std::bit_width(points)), kFewestBits);
}

// Points are dealt to a fixed number of parts, each of which counts and fills for itself: no two write to the
// same place, and earlier points come first in their cells.
struct Part {
  std::size_t first, past;
};
Part part_of(std::size_t points, std::size_t parts, std::size_t part) {
  return {points * part / parts, points * (part + 1) / parts};
}

bool has_place(const PositionColumns& at, std::size_t p) {
  return !std::isnan(at.x[p]) && !std::isnan(at.y[p]) && !std::isnan(at.z[p]);
}

}  // namespace

void NearGrid::reserve(std::size_t points, std::size_t threads) {
  const std::size_t padded = points + MF_LANES;
  for (std::vector<float>* column : {&x_, &y_, &z_}) {
    column->assign(padded, 0.0F);
  }
  for (std::vector<int>* column : {&id_, &cell_, &cell_of_}) {
    column->assign(padded, 0);
  }
  const std::size_t cells = std::size_t{1} << static_cast<unsigned>(most_bits(points));
  start_.assign(cells + 1, 0);
  next_.assign((cells + 1) * threads, 0);
  extents_.assign(threads, {});
}

void NearGrid::sort(const PositionColumns& at, float side, ThreadTeam& team) noexcept {
  // Below some thousands of points waking a second thread costs more than it brings.
  parts_ = at.x.size() < kGrain ? 1 : team.size();
  measure(at, team);
  choose_cells(side, at.x.size());
  count(at, team);
  add_up();
  fill(at, team);
}

void NearGrid::measure(const PositionColumns& at, ThreadTeam& team) noexcept {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Extent nothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  const std::array<const float*, 3> columns{at.x.data(), at.y.data(), at.z.data()};
  team.for_ranges(parts_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const auto [first, past] = part_of(at.x.size(), parts_, part);
      Extent own = nothing;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t p = first; p < past; ++p) {
          // What is no number is neither smaller nor greater.
          own.low[axis] = columns[axis][p] < own.low[axis] ? columns[axis][p] : own.low[axis];
          own.high[axis] = columns[axis][p] > own.high[axis] ? columns[axis][p] : own.high[axis];
        }
      }
      extents_[part] = own;
    }
  });
  low_ = nothing.low;
  high_ = nothing.high;
  for (std::size_t part = 0; part < parts_; ++part) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], extents_[part].low[axis]);
      high_[axis] = std::max(high_[axis], extents_[part].high[axis]);
    }
  }
}

void NearGrid::choose_cells(float side, std::size_t points) noexcept {
  constexpr float kFarthest = 1e8F;   // m
  constexpr float kThinnest = 1e-4F;  // m
  constexpr float kMostCells = 1e5F;  // along an axis
  side_ = std::max(side, kThinnest);
  std::array<float, 3> cells{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::clamp(low_[axis], -kFarthest, kFarthest);
    high_[axis] = std::clamp(high_[axis], -kFarthest, kFarthest);
    cells[axis] = std::max((high_[axis] - low_[axis]) / side_, 0.0F) + 1.0F;
  }
  // A cell's number is rounded: two points `side` apart may not come to be two cells apart by it.
  const float most = std::min(*std::max_element(cells.begin(), cells.end()), kMostCells);
  const float inverse = 1.0F / (side_ * (1.001F + 4e-7F * most));
  int total = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bits_[axis] = static_cast<int>(std::ceil(std::log2(std::min(cells[axis], 1e9F))));
    total += bits_[axis];
  }
  for (const int room = most_bits(points); total > room; --total) {
    --*std::max_element(bits_.begin(), bits_.end());
  }
  cells_ = {low_[0], low_[1], low_[2], inverse, inverse, inverse, bits_[0], bits_[1], bits_[2]};
}

void NearGrid::count(const PositionColumns& at, ThreadTeam& team) noexcept {
  const std::size_t cells = std::size_t{1} << static_cast<unsigned>(bits_[0] + bits_[1] + bits_[2]);
  team.for_ranges(parts_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const auto [first, past] = part_of(at.x.size(), parts_, part);
      int* counts = &next_[part * (cells + 1)];
      std::fill_n(counts, cells + 1, 0);
      for (std::size_t p = first; p < past; p += MF_LANES) {
        int cell[MF_LANES];
        const std::size_t lanes = std::min<std::size_t>(MF_LANES, past - p);
        float place[3][MF_LANES] = {};
        std::copy_n(&at.x[p], lanes, place[0]);
        std::copy_n(&at.y[p], lanes, place[1]);
        std::copy_n(&at.z[p], lanes, place[2]);
        const kernels::F3 r =
            kernels::mf3(kernels::mf_load(place[0]), kernels::mf_load(place[1]), kernels::mf_load(place[2]));
        kernels::mf_unpack(kernels::mf_cell_index(r, &cells_), cell);
        for (std::size_t k = 0; k < lanes; ++k) {
          // Those without a place come after all cells.
          const int own = has_place(at, p + k) ? cell[k] : static_cast<int>(cells);
          cell_of_[p + k] = own;
          ++counts[own];
        }
      }
    }
  });
}

// From counts to places.
void NearGrid::add_up() noexcept {
  const std::size_t cells = std::size_t{1} << static_cast<unsigned>(bits_[0] + bits_[1] + bits_[2]);
  int before = 0;
  double pairs = 0.0;
  for (std::size_t c = 0; c <= cells; ++c) {
    const int first = before;
    start_[c] = first;
    for (std::size_t part = 0; part < parts_; ++part) {
      int& next = next_[part * (cells + 1) + c];
      const int here = next;
      next = before;
      before += here;
    }
    pairs += c < cells ? static_cast<double>(before - first) * (before - first) : 0.0;
  }
  size_ = static_cast<std::size_t>(start_[cells]);
  mean_company_ = pairs / std::max(static_cast<double>(size_), 1.0);
}

void NearGrid::fill(const PositionColumns& at, ThreadTeam& team) noexcept {
  const std::size_t cells = std::size_t{1} << static_cast<unsigned>(bits_[0] + bits_[1] + bits_[2]);
  team.for_ranges(parts_, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t part = begin; part < end; ++part) {
      const auto [first, past] = part_of(at.x.size(), parts_, part);
      int* next = &next_[part * (cells + 1)];
      for (std::size_t p = first; p < past; ++p) {
        const int cell = cell_of_[p];
        const auto to = static_cast<std::size_t>(next[cell]++);
        x_[to] = at.x[p];
        y_[to] = at.y[p];
        z_[to] = at.z[p];
        id_[to] = static_cast<int>(p);
        cell_[to] = cell;
      }
    }
  });
}

}  // namespace mayfly
