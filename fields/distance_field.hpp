// Signed distance to the obstacles at every cell centre.
#pragma once

#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// distance[grid.index(i, j, k)]: φ in m at grid.center(i, j, k), negative inside; kNoObstacle everywhere
// without obstacles.
struct DistanceField {
  Grid grid;
  std::vector<float> distance;
};

// Exact (rounded once, to float) in every cell, not only near the surface; the same bits whatever the number
// of threads. The sign of meshes comes from scan lines of signed crossings, see fields/scan_lines.hpp.
// threads < 1 means all cores. Errors: a grid larger than make_grid() allows, or no memory for it.
Result<DistanceField> build_distance_field(const Geometry& geometry, const Grid& grid, int threads,
                                           const Progress& progress);

// The cache key (fields/cache.hpp) of that field.
std::string distance_key(const Geometry& geometry, const Grid& grid);

}  // namespace mayfly::fields
