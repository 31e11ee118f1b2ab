#include "controller/engine/neighbour_lists.hpp"

#include <algorithm>
#include <bit>

#include "controller/engine/near_scan.hpp"

namespace mayfly {
namespace {

constexpr std::size_t kChunk = 256;

}  // namespace

// Lists that grow one after the other.
class NeighbourLists::Growing {
 public:
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  const int* data() const { return ints_.data(); }
  void make_room(std::size_t more) {
    if (ints_.size() < size_ + more + MF_LANES) {
      ints_.resize(2 * (size_ + more) + MF_LANES);
    }
  }
  void add(kernels::I ids, unsigned picked) {
    store_picked(&ints_[size_], ids, picked);
    size_ += static_cast<std::size_t>(std::popcount(picked));
  }

 private:
  std::vector<int> ints_;
  std::size_t size_ = 0;
};

void NeighbourLists::find(const PositionColumns& at, float radius, ThreadTeam& team) {
  const std::size_t points = at.x.size();
  if (room_ < points || room_ == 0) {
    room_ = points;
    grid_.reserve(room_, team.size());
  }
  first_.assign(points, 0);
  count_.assign(points, 0);
  grid_.sort(at, radius, team);
  search(radius, team);
  if (used_ > all_.size()) {
    all_.resize(used_ + used_ / 8);
    search(radius, team);
  }
}

// Counts all, and keeps what there is room for.
void NeighbourLists::search(float radius, ThreadTeam& team) {
  used_ = 0;
  team.for_ranges(grid_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    Growing lists;
    for (std::size_t first = begin; first < end; first += kChunk) {
      const std::size_t past = std::min(first + kChunk, end);
      search_some(radius, first, past, lists);
      keep(first, past, lists);
      lists.clear();
    }
  });
}

void NeighbourLists::search_some(float radius, std::size_t begin, std::size_t end, Growing& lists) {
  const kernels::F radius2 = kernels::mf_splat(radius * radius);
  for (std::size_t slot = begin; slot < end; ++slot) {
    const Searcher from(grid_, slot);
    const auto point = static_cast<std::size_t>(grid_.id()[slot]);
    first_[point] = lists.size();
    grid_.for_rows(slot, radius, [&](int first, int past) {
      lists.make_room(static_cast<std::size_t>(past - first));
      scan_row(grid_, from, radius2, first, past, [&](std::size_t eight, unsigned picked, kernels::F) {
        lists.add(kernels::mf_iload(&grid_.id()[eight]), picked);
      });
    });
    count_[point] = lists.size() - first_[point];
  }
}

void NeighbourLists::keep(std::size_t begin, std::size_t end, const Growing& lists) noexcept {
  const std::size_t to = used_.fetch_add(lists.size(), std::memory_order_relaxed);
  if (to + lists.size() > all_.size()) {
    return;
  }
  std::copy_n(lists.data(), lists.size(), all_.begin() + static_cast<std::ptrdiff_t>(to));
  for (std::size_t slot = begin; slot < end; ++slot) {
    first_[static_cast<std::size_t>(grid_.id()[slot])] += to;
  }
}

}  // namespace mayfly
