// A scenario's world, built: the solid, its distance field, and the cost field of each swarm.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller/flight/field_solver.hpp"
#include "controller/flight/moving_body.hpp"
#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/nested_grid.hpp"
#include "core/progress.hpp"
#include "fields/cache.hpp"
#include "fields/cost_field.hpp"
#include "fields/distance_field.hpp"
#include "fields/geometry.hpp"

namespace mayfly {

struct World {
  Grid grid;
  // Given: distance, walls and costs lie on this, and `grid` is the fine grid that its bricks are cut from.
  std::shared_ptr<const NestedGrid> nested{};
  fields::Geometry solid;          // exact, all obstacles that stand still
  fields::DistanceField distance;  // of the same
  std::vector<MovingBody> moving;  // the other obstacles
  // Spline coefficients of the distance, for the kernels; of all obstacles, as the flight begins.
  std::vector<float> walls;
  std::vector<fields::Geometry> goals;  // exact, one a goal of the scenario, in its order
  // One a swarm, in the scenario's order; swarms with the same goal and weights share one. Null for those
  // that no field leads.
  std::vector<std::shared_ptr<const fields::CostField>> costs;
  // Solves again what changes in flight; null where nothing does.
  std::shared_ptr<FieldSolver> solver;
  PreprocessingSummary preprocessing;
  std::vector<Error> warnings;  // "1 204 free cells cannot reach goal 'exit'"
};

// φ (m) when the flight begins, obstacles that move as large as the first fields make them.
float distance_at_start(const World& world, glm::vec3 p) noexcept;

// Builds the fields (or takes them from the cache on disk). Errors name the place in the scenario: an open
// mesh, a goal inside an obstacle, a start region that cannot reach its goal.
tl::expected<World, std::vector<Error>> build_world(const Scenario& scenario, int threads,
                                                    const Progress& progress,
                                                    const fields::FieldCache& cache = fields::FieldCache());

}  // namespace mayfly
