// The minimum-cost field of one goal in a large world (docs/decisions/ on nested grids; model.md §3).
#pragma once

#include <memory>
#include <span>

#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/cost_field.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// φ (m) on a nested grid, as build_nested_distance gives it; both outlive what is made of them.
struct NestedObstacles {
  std::shared_ptr<const NestedGrid> nested;
  std::span<const float> distance;
};

// As build_cost_field, on a nested grid whose bricks reach at least as far as the influence, a cell more than
// the clearance, and three cells from the goal's surface. Wherever the straight way to the nearest point of
// the goal keeps clear of obstacles by the influence, the cost is that way's length and the direction its
// own, without an error of the grid's. Elsewhere: fields/nested_march.hpp. The same bits for any number of
// threads. Errors: a parameter out of range; a goal outside the world or inside obstacles; no memory.
Result<CostField> build_nested_cost(const NestedObstacles& obstacles, const Geometry& goal,
                                    const CostParams& params, int threads, const Progress& progress);

}  // namespace mayfly::fields
