// From costs on a nested grid to directions. For nested_cost.cpp only.
#pragma once

#include "core/progress.hpp"
#include "fields/cost_field.hpp"
#include "fields/nested_march.hpp"

namespace mayfly::fields {

struct NestedGuideInput {
  const NestedCosts& costs;
  float clearance = 0.0F;  // m, effective
};

// Fills field.guide (in which the cells of fixed cost have their direction already) and field.kind (complete
// for leaves). Fine cells get theirs from make_guide, coarse ones the direction of their ray. Across the
// sides of bricks that lie beside coarse cells the interpolated direction is continuous: over two fine cells
// the brick's own directions give way to the coarse ones, and its apron holds those.
void fill_nested_guide(const NestedGuideInput& input, int threads, const Progress& progress,
                       CostField& field);

}  // namespace mayfly::fields
