// All neighbours of all points within one radius, exactly.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/near_grid.hpp"

namespace mayfly {

class NeighbourLists {
 public:
  // Of points that have a place; others have no neighbours and are nobody's. Radius in m; a distance of just
  // the radius counts. Allocates where there are more points or pairs than ever before.
  void find(const PositionColumns& at, float radius, ThreadTeam& team);

  // Of point `p`: numbers of points, the same in the same order on any number of threads.
  std::span<const int> of(std::size_t p) const {
    const auto slot = static_cast<std::size_t>(slot_of_[p]);
    const std::size_t first = start_[slot];
    return std::span(all_).subspan(first, start_[slot + 1] - first);
  }
  // In all lists together: every pair twice.
  std::size_t size() const { return start_[count_]; }

 private:
  void count(float radius, ThreadTeam& team);
  void fill(float radius, ThreadTeam& team);
  void fill_one(std::size_t slot, float radius, const int* last) noexcept;

  NearGrid grid_;
  std::size_t room_ = 0;  // points
  std::size_t count_ = 0;
  std::vector<int> slot_of_;        // one a point
  std::vector<std::size_t> start_;  // one a sorted point, and one past the last
  std::vector<int> all_;
};

}  // namespace mayfly
