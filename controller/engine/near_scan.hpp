// Looks at the points of a NearGrid's row eight at a time.
#pragma once

#include <cstddef>

#include "controller/engine/lane_pick.hpp"
#include "controller/engine/near_grid.hpp"

namespace mayfly {

// The point whose neighbours are looked for.
struct Searcher {
  Searcher(const NearGrid& grid, std::size_t slot)
      : x(kernels::mf_splat(grid.x()[slot])),
        y(kernels::mf_splat(grid.y()[slot])),
        z(kernels::mf_splat(grid.z()[slot])),
        self(kernels::mf_isplat(static_cast<int>(slot))) {}
  kernels::F x, y, z;
  kernels::I self;
};

// Calls hit(first of eight sorted points, which of them are no farther than √radius2 (m²), their squared
// distances) for all eights of the row; the searcher is not among them.
template <class Hit>
inline void scan_row(const NearGrid& grid, const Searcher& from, kernels::F radius2, int first, int past,
                     Hit&& hit) {
  const float* x = grid.x().data();
  const float* y = grid.y().data();
  const float* z = grid.z().data();
  for (int eight = first; eight < past; eight += MF_LANES) {
    const auto a = static_cast<std::size_t>(eight);
    const kernels::F dx = kernels::mf_load(x + a) - from.x;
    const kernels::F dy = kernels::mf_load(y + a) - from.y;
    const kernels::F dz = kernels::mf_load(z + a) - from.z;
    const kernels::F distance2 = dx * dx + dy * dy + dz * dz;
    const kernels::I slots = kernels::mf_lane_index() + eight;
    hit(a, mask_bits((distance2 <= radius2) & (slots < kernels::mf_isplat(past)) & (slots != from.self)),
        distance2);
  }
}

}  // namespace mayfly
