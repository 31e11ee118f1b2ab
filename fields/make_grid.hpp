// From a box and a cell side to a grid of a size that can be afforded.
#pragma once

#include <cstddef>

#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly::fields {

inline constexpr std::size_t kMaxCells = std::size_t{1} << 28;  // 1 GiB of floats

// Covers `bounds` (m) with cubes of side `cell` (m); the box need not be a multiple of it, so the grid may
// stick out at the far sides by less than a cell. Refuses an empty or infinite box, a cell that is not
// positive, and more than kMaxCells cells, naming the cell side that would fit. Allocates nothing.
Result<Grid> make_grid(const Box& bounds, float cell);

// What builders of fields ask for: at least one cell along each axis, no more than kMaxCells.
Result<void> check_grid(const Grid& grid);

}  // namespace mayfly::fields
