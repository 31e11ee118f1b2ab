// The fields of a world in which goals or obstacles move or crowds count, solved for one time after another.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "controller/flight/field_set.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"
#include "fields/cost_solver.hpp"
#include "fields/cost_terms.hpp"
#include "fields/distance_field.hpp"
#include "fields/moving_obstacles.hpp"

namespace mayfly {

// What goals do between two solves is known: a goal is put where it will be in the middle of the time that
// the set is flown by. An obstacle is put there too, and made larger by as much as it moves from there to
// either end of that time, and by the way that agents may lag behind a wall that comes at them; so the walls
// of a set hold the obstacle wherever it is while they are flown by (docs/explanation/fields-in-flight.md).
class FieldSolver {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // `still`: the distance to what does not move; its values must outlive the solver, as must `scenario`.
  // Errors: those of fields::CostSolver and fields::MovingObstacles.
  static Result<FieldSolver> make(const Scenario& scenario, const fields::DistanceField& still, int threads);

  // Which of FieldSet::costs a swarm flies by; kNone where its fields stay as they are.
  std::size_t cost_of(std::size_t swarm) const { return cost_of_[swarm]; }
  bool walls_change() const { return obstacles_.has_value(); }

  // Of the right sizes, for solve() to write into.
  FieldSet make_set() const;

  // Writes all of `set`. The bits do not depend on the number of threads. A goal that cannot be reached, or
  // has left the world, is no error but told in the set. Errors: no memory, no thread.
  Result<void> solve(const FieldInputs& inputs, int threads, FieldSet& set);

  // m: by how much obstacle `index` of the scenario is made larger in a set flown by from `from_s` to
  // `until_s`. 0 where it stands still.
  float margin(std::size_t index, double from_s, double until_s) const;

 private:
  struct Cost {
    fields::CostSolver solver;
    std::size_t goal = 0;
    float density_weight = 0.0F;
    std::vector<float> brushes;  // extra slowness that stays as it is; empty: none
    std::vector<float> extra;    // all of it; empty: none
  };

  explicit FieldSolver(const Scenario& scenario) : scenario_(scenario) {}
  Result<void> add_costs();
  Result<void> add_obstacles(const fields::DistanceField& still, int threads);
  Result<void> move_obstacles(const FieldInputs& inputs, int threads, FieldSet& set);
  Result<void> gather_density(const FieldInputs& inputs);
  Result<void> solve_cost(std::size_t cost, glm::vec3 goal_offset, int threads, FieldSet& set);
  void find_cut_off(const FieldInputs& inputs, FieldSet& set) const;

  const Scenario& scenario_;
  Grid grid_;
  std::span<const float> still_;  // φ, m
  std::optional<fields::MovingObstacles> obstacles_;
  std::vector<std::size_t> moving_;  // indices in the scenario
  std::vector<glm::vec3> offsets_;   // m, one a moving obstacle
  std::vector<float> margins_;       // m
  std::vector<Cost> costs_;
  std::vector<std::size_t> cost_of_;  // one a swarm
  std::vector<float> density_;        // agents/m³; empty where it does not count
};

}  // namespace mayfly
