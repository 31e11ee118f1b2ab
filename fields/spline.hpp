// From samples to the coefficients of the quadratic B-spline that runs through them.
#pragma once

#include <span>
#include <vector>

#include "core/grid.hpp"

namespace mayfly::fields {

// `values` at cell centres, one a cell. A B-spline of the values themselves would smooth them: a ball would
// shrink, a box lose its edges. Of these coefficients it gives back every value at its cell centre (Unser
// 1993; mirrored at the borders).
std::vector<float> spline_coefficients(const Grid& grid, std::span<const float> values);

// The same into `coefficients`, of the same size; the same bits on any number of threads (< 1: all cores).
void fill_spline_coefficients(const Grid& grid, std::span<const float> values, int threads,
                              std::span<float> coefficients);

}  // namespace mayfly::fields
