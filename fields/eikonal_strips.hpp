// How the eikonal solver lays a grid out so that a whole Gauss–Seidel sweep runs on eight lanes. For
// eikonal.cpp only.
//
// Eight rows (along x) that lie side by side in y make a strip. Lane l of its n-th vector holds cell x = n −
// l of row l: in a sweep towards +x and +y the left and the lower neighbour of every lane are in vector n −
// 1, which is done, and the right and the upper one in vector n + 1, which is not. So eight cells are updated
// at once in exactly the order of a scalar sweep. The same holds backwards, towards −x and −y; sweeps towards
// (+x, −y) and (−x, +y) run on a copy whose y axis is flipped. Four strips above each other in z make a
// brick: they are swept together, each one vector behind the one before, because one strip alone would wait
// for the latency of its own square roots.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "core/grid.hpp"
#include "kernels/lane.h"

namespace mayfly::fields::strips {

inline constexpr int kRows = MF_LANES;  // of a strip
inline constexpr int kPlanes = 4;       // of a brick
inline constexpr int kLag =
    kRows - 1 + kPlanes - 1;  // a brick's last cell of column x comes this many steps after its first
inline constexpr int kPad =
    12;  // vectors before and after a strip: what a lane reads or touches beyond its row

// Stand-ins for infinity whose squares and sums are finite, so that no ∞ − ∞ arises and no lane needs a
// special case: an open cell that has not been reached, a cell that never changes, and the step cost
// (slowness · cell) of the latter, from which no neighbours give a value below kClosed.
inline constexpr float kFar = 1e18F;
inline constexpr float kClosed = 2e18F;
inline constexpr float kClosedStep = 8e18F;

struct Layout {
  int nx, ny, nz;
  int strips, bricks;
  std::size_t row_vectors;    // vectors of a strip
  std::size_t plane_vectors;  // vectors of a plane

  explicit Layout(glm::ivec3 cells)
      : nx(cells.x),
        ny(cells.y),
        nz(cells.z),
        strips((cells.y + kRows - 1) / kRows),
        bricks((cells.z + kPlanes - 1) / kPlanes),
        row_vectors(static_cast<std::size_t>(nx + kRows - 1 + 2 * kPad)),
        plane_vectors(row_vectors * static_cast<std::size_t>(strips + 2)) {}

  int planes() const { return bricks * kPlanes; }
  // Floats of a table: one border plane on each side in z, one border strip in y.
  std::size_t size() const { return plane_vectors * static_cast<std::size_t>(planes() + 2) * MF_LANES; }
  // Where vector 0 of a strip begins, in floats. strip may be −1 or `strips`, z may be −1 or planes().
  std::size_t strip_begin(int strip, int z) const {
    return (plane_vectors * static_cast<std::size_t>(z + 1) +
            row_vectors * static_cast<std::size_t>(strip + 1) + kPad) *
           MF_LANES;
  }
  // Where the row y of plane z begins: its cell x is at row_begin + x · MF_LANES.
  std::size_t row_begin(int y, int z) const {
    const auto lane = static_cast<std::size_t>(y % kRows);
    return strip_begin(y / kRows, z) + lane * (MF_LANES + 1);
  }
};

// A half-open range of x in which cells wait to be updated.
struct Range {
  int begin = 0;
  int end = 0;

  bool empty() const { return begin >= end; }
  void add(Range other) {
    if (other.empty()) {
      return;
    }
    if (empty()) {
      *this = other;
    } else {
      begin = std::min(begin, other.begin);
      end = std::max(end, other.end);
    }
  }
};

// Which neighbours of a brick were left with work by an update of it: ranges of x.
struct Outcome {
  Range changed;          // cells that changed
  Range self;             // cells of this brick that come earlier in the sweep
  Range y_back, y_ahead;  // the next strips: the one swept before this, the one swept after
  Range z_back, z_ahead;  // the next bricks, likewise
  std::uint64_t steps = 0;
};

// Addresses, in floats, of a brick: vector 0 of each plane in the order in which a sweep takes them, with the
// plane before (index 0) and the one after (index kPlanes + 1); and how far the strips at the smaller and
// larger y are.
struct Brick {
  std::size_t plane[kPlanes + 2];
  std::ptrdiff_t strip_stride;
};

// Updates the cells of a brick whose x is in `range`, and those that their changes reach, in the order of a
// sweep towards +x, +y (kStep = 1) or −x, −y (kStep = −1). cost and step are tables of one Layout.
template <int kStep>
Outcome sweep_brick(float* cost, const float* step, const Brick& brick, const Layout& layout, Range range);

extern template Outcome sweep_brick<1>(float*, const float*, const Brick&, const Layout&, Range);
extern template Outcome sweep_brick<-1>(float*, const float*, const Brick&, const Layout&, Range);

}  // namespace mayfly::fields::strips
