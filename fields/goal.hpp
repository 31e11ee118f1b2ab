// A goal region as a signed distance, and the cells from which costs are counted.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/grid.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/distance_field.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

// distance[grid.index(i, j, k)]: signed distance (m) from a cell's centre to the goal's surface, negative
// inside.
struct GoalDistance {
  Grid grid;
  std::vector<float> distance;
  std::optional<glm::vec3> middle;  // of the shape, where that lies inside or less than a cell from it
  Place place;                      // where the scenario names it, for errors
};

// Samples a goal on `grid`, displaced by `offset` (m). Any shape will do; a mesh is loaded and checked as an
// obstacle is, and errors are those of Geometry::make and build_distance_field. threads < 1 means all cores.
Result<GoalDistance> build_goal_distance(const PlacedShape& shape, const Grid& grid, int threads,
                                         const Progress& progress, glm::vec3 offset = glm::vec3(0.0F));

// Writes the fixed costs (m: A = 1) into `cost`, one value a cell, and +inf elsewhere: φ_goal in every free
// cell whose centre is in the goal, negative by its depth, so that the first cells outside see the surface
// where it is, not where the grid is. A goal that holds no cell centre is met by the nearest free one, if
// that is within a cell side: it and the free cells joined to it within 1½ sides get their distance φ_goal >
// 0, and are listed in `small`, which is empty otherwise. A cell is free where obstacles ≥ clearance (m).
// Farther than 1½ sides from the goal, goal.distance need not be exact. Errors (kCaller): the goal is outside
// the grid; it lies inside obstacles; the arrays' sizes differ; a distance is not a number.
Result<void> place_sources(std::span<const float> obstacles, const GoalDistance& goal, float clearance,
                           std::span<float> cost, std::vector<std::size_t>& small);

}  // namespace mayfly::fields
