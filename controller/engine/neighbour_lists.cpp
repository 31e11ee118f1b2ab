#include "controller/engine/neighbour_lists.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "controller/engine/near_scan.hpp"

namespace mayfly {
namespace {

constexpr std::size_t kChunk = 256;

// Those lanes that are picked; where there is room, eight are written at a time.
int* append(int* to, const int* last, kernels::I ids, unsigned picked) noexcept {
  const int found = std::popcount(picked);
  if (last - to >= MF_LANES) {
    store_picked(to, ids, picked);
  } else {
    std::array<int, MF_LANES> eight{};
    store_picked(eight.data(), ids, picked);
    std::copy_n(eight.begin(), found, to);
  }
  return to + found;
}

}  // namespace

void NeighbourLists::find(const PositionColumns& at, float radius, ThreadTeam& team) {
  count_ = at.x.size();
  if (room_ < count_ || room_ == 0) {
    room_ = count_;
    grid_.reserve(room_, team.size());
  }
  slot_of_.resize(count_);
  start_.resize(count_ + 1);
  grid_.sort(at, radius, team);
  // Those without a place come last, each with an empty list.
  std::fill(slot_of_.begin(), slot_of_.end(), static_cast<int>(grid_.size()));
  count(radius, team);
  std::size_t before = 0;
  for (std::size_t slot = 0; slot < grid_.size(); ++slot) {
    const std::size_t here = start_[slot];
    start_[slot] = before;
    before += here;
  }
  std::fill(start_.begin() + static_cast<std::ptrdiff_t>(grid_.size()), start_.end(), before);
  if (all_.size() < before) {
    all_.resize(before + before / 8);
  }
  fill(radius, team);
}

void NeighbourLists::count(float radius, ThreadTeam& team) {
  const kernels::F radius2 = kernels::mf_splat(radius * radius);
  team.for_ranges(grid_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const Searcher from(grid_, slot);
      int found = 0;
      grid_.for_rows(slot, radius, [&](int first, int past) {
        scan_row(grid_, from, radius2, first, past,
                 [&](std::size_t, unsigned picked, kernels::F) { found += std::popcount(picked); });
      });
      start_[slot] = static_cast<std::size_t>(found);
      slot_of_[static_cast<std::size_t>(grid_.id()[slot])] = static_cast<int>(slot);
    }
  });
}

void NeighbourLists::fill(float radius, ThreadTeam& team) {
  team.for_ranges(grid_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    // What comes after belongs to others, who may have written it already.
    const int* last = all_.data() + start_[end];
    for (std::size_t slot = begin; slot < end; ++slot) {
      fill_one(slot, radius, last);
    }
  });
}

void NeighbourLists::fill_one(std::size_t slot, float radius, const int* last) noexcept {
  const Searcher from(grid_, slot);
  const kernels::F radius2 = kernels::mf_splat(radius * radius);
  int* to = all_.data() + start_[slot];
  grid_.for_rows(slot, radius, [&](int first, int past) {
    scan_row(grid_, from, radius2, first, past, [&](std::size_t eight, unsigned picked, kernels::F) {
      to = append(to, last, kernels::mf_iload(&grid_.id()[eight]), picked);
    });
  });
}

}  // namespace mayfly
