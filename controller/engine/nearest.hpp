// The nearest few of all points within a range, exactly.
#pragma once

#include <cstddef>
#include <span>

#include "controller/engine/near_grid.hpp"

namespace mayfly {

struct NearestQuery {
  float range = 0.0F;  // m: nobody farther counts
  int most = 0;        // at most kMostNearest
};

inline constexpr int kMostNearest = 16;

// Writes the sorted numbers of the points nearest to sorted point `slot`, itself left out, nearest first; of
// two that are as near, the one with the lower id() comes first. What is left of the kMostNearest places
// becomes -1. Gives up, with false, where it would have to look farther than `patience` (m): small cells
// are slow where points are few.
bool find_nearest(const NearGrid& grid, std::size_t slot, const NearestQuery& query, float patience,
                  std::span<int, kMostNearest> out) noexcept;

}  // namespace mayfly
