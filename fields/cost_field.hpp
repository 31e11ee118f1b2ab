// The minimum-cost field of one goal, and the guide that agents fly by (Wang14 §5.2, Eqs. 4, 7, 8; model.md
// §3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid.hpp"
#include "core/nested_grid.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/cost_terms.hpp"
#include "fields/distance_field.hpp"
#include "fields/goal.hpp"

namespace mayfly::fields {

// The cost of a path is A · length + B · ∫g ds + ∫extra ds, g = h(φ/influence) with h the bell of Wang14
// Eq. 6, extra from CostTerms; a metre costs no less than kLeastSlowness · A.
struct CostParams {
  float length_weight = 0.6F;     // A, > 0
  float repulsion_weight = 0.4F;  // B, ≥ 0
  float influence = 0.0F;         // m; 0 means 2√2 cells, Wang14's 2a
  float clearance = 0.0F;         // m, the body's radius: an agent's centre comes no nearer to an obstacle
};

enum class CellKind : std::uint8_t { kReached, kUnreachable, kBlocked };

// What stands in the guide for "no path": large, yet finite, because the guide is interpolated.
inline constexpr float kUnreachableGuide = 1e9F;

struct CostField {
  Grid grid;
  // Null for one value a cell of `grid`; else guide and kind have one an entry of this, and `grid` is its
  // fine grid.
  std::shared_ptr<const NestedGrid> nested;
  // Four floats a cell: a direction (x, y, z) and C/A in m. To be interpolated trilinearly between cell
  // centres, then normalised. In a reached cell the direction is −∇C/|∇C|, turned along the wall where one is
  // near, of length 1; 0 only at the deepest places of the goal. Inside the goal C/A is minus the depth. A
  // blocked cell holds what makes the interpolation right for an agent beside it: its neighbours' direction
  // and cost, led away from the wall; deeper inside, the way out. An unreachable cell holds (0, 0, 0,
  // kUnreachableGuide).
  std::vector<float> guide;
  std::vector<CellKind> kind;
  std::size_t blocked = 0;      // cells nearer to an obstacle than the clearance, or inside it
  std::size_t unreachable = 0;  // free cells that no path joins to the goal
  std::optional<glm::vec3> unreachable_example;  // m, the centre of the first of them

  // C/A at the cell that holds p; where that is blocked, at the nearest free of the eight around p. +inf: no
  // way to the goal from there, or p is outside the grid, not a number, or surrounded by blocked cells.
  float cost_at(glm::vec3 p) const;
  bool reaches(glm::vec3 p) const;
  // visit(entry, center, side) for every cell in which the field was solved; center and side in m.
  void for_each_cell(const auto& visit) const;
  // The centre of the first unreachable cell whose centre is in `region`.
  std::optional<glm::vec3> unreachable_in(const Box& region) const;
};

void CostField::for_each_cell(const auto& visit) const {
  if (nested) {
    nested->for_each_leaf([&](const NestedGrid::Leaf& leaf) { visit(leaf.entry, leaf.center, leaf.side); });
    return;
  }
  for (int k = 0; k < grid.cells.z; ++k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        visit(grid.index(i, j, k), grid.center(i, j, k), grid.cell);
      }
    }
  }
}

// max(clearance, ½ cell), less a thousandth so that rounding does not close a passage that fits exactly.
// Cells nearer to an obstacle are impassable. With at least half a cell every wall that is thicker than a
// thousandth of a cell is tight, however thin: of two neighbouring centres on its two sides, joined by a line
// of one cell side that runs through the wall for t, φ₁ + φ₂ ≤ cell − t, so that one of them is below ½ cell,
// and six neighbours give no other way across.
float effective_clearance(const CostParams& params, const Grid& grid);

// threads < 1 means all cores; the result has the same bits for any number. Errors: those of place_sources
// and solve_eikonal; a parameter out of range; extra slowness of another size, or not finite; no memory.
Result<CostField> build_cost_field(const DistanceField& obstacles, const GoalDistance& goal,
                                   const CostParams& params, int threads, const Progress& progress,
                                   const CostTerms& terms = {});

// Everything that the guide depends on: the key under which a FieldCache keeps it.
std::string cost_key(const DistanceField& obstacles, const GoalDistance& goal, const CostParams& params,
                     const CostTerms& terms = {});
// The rest of a CostField from a guide that build_cost_field made of the same obstacles and parameters.
CostField restore_cost_field(const DistanceField& obstacles, const CostParams& params,
                             std::vector<float> guide);

// "1 204 free cells cannot reach goal 'exit', for instance at (3.5, 2.5, 10.5)"; empty if all can.
std::string describe_unreachable(const CostField& field, std::string_view goal);

}  // namespace mayfly::fields
