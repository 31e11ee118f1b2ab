// All neighbours of all points within one radius, exactly.
#pragma once

#include <atomic>
#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/near_grid.hpp"

namespace mayfly {

class NeighbourLists {
 public:
  // Of points that have a place; others have no neighbours and are nobody's. Radius in m; a distance of just
  // the radius counts. Allocates.
  void find(const PositionColumns& at, float radius, ThreadTeam& team);

  // Of point `p`: numbers of points, the same in the same order on any number of threads.
  std::span<const int> of(std::size_t p) const { return std::span(all_).subspan(first_[p], count_[p]); }
  // In all lists together: every pair twice.
  std::size_t size() const { return used_; }

 private:
  class Growing;

  void search(float radius, ThreadTeam& team);
  void search_some(float radius, std::size_t begin, std::size_t end, Growing& lists);
  void keep(std::size_t begin, std::size_t end, const Growing& lists) noexcept;

  NearGrid grid_;
  std::size_t room_ = 0;                    // points
  std::vector<std::size_t> first_, count_;  // one a point
  std::vector<int> all_;                    // lists in any order
  std::atomic<std::size_t> used_{0};
};

}  // namespace mayfly
