#include "controller/engine/nearest.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

#include "controller/engine/near_scan.hpp"

namespace mayfly {
namespace {

using kernels::F;
using kernels::I;

// Those found so far. When there is no room for eight more, the nearest are kept, and the last of them says
// how far it is worth looking.
class Found {
 public:
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what is found is written before it is read
  Found(const NearGrid& grid, std::size_t slot, int most)
      : grid_(grid), from_(grid, slot), slot_(slot), most_(most) {}

  int count() const { return count_; }

  void within(float radius) {
    count_ = 0;
    farthest2_ = radius * radius;
    grid_.for_rows(slot_, radius, [this](int first, int past) { add(first, past); });
  }

  // Puts the nearest first, in order.
  void sort() {
    std::array<int, kPadded> rank{};
    if (rank_all(rank)) {
      place(rank);
    } else {
      sort_ties();
    }
    count_ = std::min(count_, most_);
  }

  int slot(int n) const { return slots_[static_cast<std::size_t>(n)]; }

 private:
  static constexpr int kRoom = 64;
  static constexpr int kPadded = kRoom + MF_LANES;

  void add(int first, int past) {
    scan_row(grid_, from_, kernels::mf_splat(farthest2_), first, past,
             [this](std::size_t eight, unsigned picked, F distance2) {
               const auto end = static_cast<std::size_t>(count_);
               store_picked(&distance2_[end], distance2, picked);
               store_picked(&slots_[end], kernels::mf_lane_index() + static_cast<int>(eight), picked);
               count_ += std::popcount(picked);
               if (count_ > kRoom - MF_LANES) {
                 sort();
                 farthest2_ = distance2_[static_cast<std::size_t>(count_ - 1)];
               }
             });
  }

  // How many are nearer than each. False if any two are equally near.
  bool rank_all(std::array<int, kPadded>& rank) {
    std::fill_n(distance2_.begin() + count_, MF_LANES, std::numeric_limits<float>::infinity());
    I all = kernels::mf_isplat(0);
    for (int n = 0; n < count_; n += MF_LANES) {
      const F own = kernels::mf_load(&distance2_[static_cast<std::size_t>(n)]);
      I nearer = kernels::mf_isplat(0);
      for (int m = 0; m < count_; ++m) {
        nearer -= kernels::mf_splat(distance2_[static_cast<std::size_t>(m)]) < own;
      }
      std::memcpy(&rank[static_cast<std::size_t>(n)], &nearer, sizeof nearer);
      all += kernels::mf_iselect(kernels::mf_lane_index() + n < kernels::mf_isplat(count_), nearer,
                                 kernels::mf_isplat(0));
    }
    int sum = 0;
    for (int lane = 0; lane < MF_LANES; ++lane) {
      sum += all[lane];
    }
    return sum == count_ * (count_ - 1) / 2;
  }

  void place(const std::array<int, kPadded>& rank) {
    const auto distance2 = distance2_;
    const auto slots = slots_;
    for (std::size_t n = 0; n < static_cast<std::size_t>(count_); ++n) {
      const auto to = static_cast<std::size_t>(rank[n]);
      distance2_[to] = distance2[n];
      slots_[to] = slots[n];
    }
  }

  void sort_ties() {
    std::array<std::pair<float, int>, kPadded> order;
    const auto count = static_cast<std::size_t>(count_);
    for (std::size_t n = 0; n < count; ++n) {
      order[n] = {distance2_[n], slots_[n]};
    }
    std::sort(order.begin(), order.begin() + count_, [this](const auto& a, const auto& b) {
      const auto id = [this](int slot) { return grid_.id()[static_cast<std::size_t>(slot)]; };
      return a.first < b.first || (a.first == b.first && id(a.second) < id(b.second));
    });
    for (std::size_t n = 0; n < count; ++n) {
      distance2_[n] = order[n].first;
      slots_[n] = order[n].second;
    }
  }

  const NearGrid& grid_;
  Searcher from_;
  std::size_t slot_;
  int most_;
  int count_ = 0;
  float farthest2_ = 0.0F;  // m²
  alignas(32) std::array<float, kPadded> distance2_;
  alignas(32) std::array<int, kPadded> slots_;
};

}  // namespace

bool find_nearest(const NearGrid& grid, std::size_t slot, const NearestQuery& query, float patience,
                  std::span<int, kMostNearest> out) noexcept {
  Found found(grid, slot, query.most);
  // In a crowd enough are found long before the range is searched.
  float radius = std::min(query.range, grid.side());
  found.within(radius);
  while (found.count() < query.most && radius < query.range) {
    radius = std::min(query.range, 2 * radius);
    if (radius > patience) {
      return false;
    }
    found.within(radius);
  }
  found.sort();
  std::fill(out.begin(), out.end(), -1);
  for (int n = 0; n < found.count(); ++n) {
    out[static_cast<std::size_t>(n)] = found.slot(n);
  }
  return true;
}

}  // namespace mayfly
