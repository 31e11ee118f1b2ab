// Walls that are never farther off than the solid that they stand for.
#pragma once

#include <span>

#include "fields/distance_field.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// A spline through one sample a cell knows nothing of what lies between: it cuts corners, and beside a post
// that is thinner than a few cells it tells up to a third of a cell more room than there is. Lowers
// `coefficients` (those of spline_coefficients(distance)) so that within a cell of the surface the spline
// tells no more than solid.signed_distance does, at eight points in each cell; between those points it may,
// by some hundredths of a cell at sharp edges. Where the spline was right nothing changes. The same bits on
// any number of threads (< 1: all cores).
void lower_walls(const Geometry& solid, const DistanceField& distance, int threads,
                 std::span<float> coefficients);

}  // namespace mayfly::fields
