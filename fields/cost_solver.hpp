// One goal's cost field, solved again and again in flight: for a goal that moved, obstacles that moved, a
// crowd or brushes that changed.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/grid.hpp"
#include "core/result.hpp"
#include "fields/cost_field.hpp"
#include "fields/cost_terms.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

// What a solve starts from. The spans must hold one value a cell of the solver's grid, and live until solve()
// returns.
struct CostInput {
  std::span<const float> distance;  // φ of the obstacles, m
  glm::vec3 goal_offset{0.0F};      // m, how far the goal is from where its shape was given
  CostTerms terms;
};

struct SolveStats {
  int sweeps = 0;
  bool local = false;      // only what lies behind the changed cells was solved
  std::size_t solved = 0;  // cells that were open to change
};

// Owns all buffers for one grid, one goal and one set of parameters. Not for several threads at once.
class CostSolver {
 public:
  // `goal`: the shape where it is without an offset; a mesh is loaded and checked here, once. Errors: those
  // of Geometry::make; a parameter out of range; no memory.
  static Result<CostSolver> make(const Grid& grid, const PlacedShape& goal, const CostParams& params);

  CostSolver(CostSolver&&) noexcept;
  CostSolver& operator=(CostSolver&&) noexcept;
  ~CostSolver();

  // A field that solve() can write without asking for memory.
  CostField make_field() const;

  // Writes all of `field`: what build_cost_field makes of the same obstacles, the displaced goal and the same
  // terms, bit for bit unless the solve was local (then to the rounding of a few float32 steps). threads < 1
  // means all cores; the bits do not depend on it. Asks for no memory but what threads > 1 take to start. On
  // an error (those of place_sources and solve_eikonal: the goal left the world, or is inside obstacles)
  // `field` is as it was.
  //
  // Local: the upwind scheme is causal, a cell's cost depends on smaller costs only. Where the sources are
  // the same as in the solve before and only some cells' slowness changed, costs up to the least among those
  // cells and their neighbours cannot change. They are kept, and only the rest is solved.
  Result<SolveStats> solve(const CostInput& input, int threads, CostField& field);

 private:
  struct State;
  explicit CostSolver(std::unique_ptr<State> state) noexcept;

  std::unique_ptr<State> state_;
};

}  // namespace mayfly::fields
