// Signed distance to the obstacles of a large world: fine near them, coarse elsewhere.
#pragma once

#include <span>
#include <vector>

#include "core/grid.hpp"
#include "core/nested_grid.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// Where fine cells are needed, m.
struct BrickReach {
  float outside = 0.0F;  // of an obstacle's surface
  float inside = 0.0F;
  float goal = 0.0F;  // of a goal's surface, on both sides
};

struct NestedDistance {
  NestedGrid nested;
  std::vector<float> distance;  // φ in m, one an entry of `nested`, each exact at its cell's centre
};

// Covers `bounds` (m) with coarse cells of 8 × `cell` (m). A coarse cell without a brick lies farther than
// `reach.outside` from every obstacle (or deeper than `reach.inside` in one), and farther than `reach.goal`
// from every goal's surface, with all of its points. threads < 1 means all cores; the result has the same
// bits for any number. Errors: sides that are no whole multiple of a coarse cell, more entries than a table
// may have, no memory.
Result<NestedDistance> build_nested_distance(const Geometry& obstacles, std::span<const Geometry> goals,
                                             const Box& bounds, float cell, const BrickReach& reach,
                                             int threads, const Progress& progress);

// The signed distance to any geometry on a nested grid that is there already.
Result<std::vector<float>> sample_nested(const Geometry& geometry, const NestedGrid& nested, int threads,
                                         const Progress& progress);

// What kernels sample near obstacles (kernels/bricks.h): in bricks the coefficients of the spline through φ
// (fields/spline.hpp), m; for each coarse cell, bit by bit, the whole number of its brick's first entry, 0
// for none.
std::vector<float> nested_walls(const NestedDistance& field, int threads, const Progress& progress);

}  // namespace mayfly::fields
