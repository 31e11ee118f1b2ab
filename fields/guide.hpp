// From costs to directions, in every cell that an agent's interpolation may touch. For cost_field.cpp only.
#pragma once

#include <span>

#include "core/grid.hpp"
#include "core/progress.hpp"
#include "fields/cost_field.hpp"

namespace mayfly::fields {

// What guide and kind are made from. All arrays hold one value a cell of `grid`.
struct GuideInput {
  Grid grid;
  std::span<const float> distance;  // φ, m
  std::span<const float> cost;      // C/A, m; +inf where blocked or unreachable
  std::span<const CellKind> kind;
  float clearance = 0.0F;  // m, effective
};

// Writes the guide of a CostField: 4 floats a cell.
void make_guide(const GuideInput& input, std::span<float> guide, int threads, const Progress& progress);

// Leads to `middle` in the given cells: for a goal too small for differences between cells to point at it.
void point_at(glm::vec3 middle, const Grid& grid, std::span<const std::size_t> cells, std::span<float> guide);

}  // namespace mayfly::fields
