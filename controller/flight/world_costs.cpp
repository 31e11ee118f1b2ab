#include "controller/flight/world_costs.hpp"

#include <algorithm>
#include <utility>

#include "controller/flight/field_margin.hpp"
#include "controller/flight/swarm_cost.hpp"
#include "fields/goal.hpp"
#include "fields/nested_cost.hpp"

namespace mayfly {

std::vector<Error> WorldCosts::add_to(World& world) {
  const auto start = std::chrono::steady_clock::now();
  const auto& swarms = scenario_.swarms;
  if (std::any_of(swarms.begin(), swarms.end(),
                  [&](const SwarmSpec& swarm) { return changes_in_flight(scenario_, swarm); })) {
    solve_changing(world);
    if (world.solver == nullptr) {
      return std::move(errors_);
    }
  }
  for (std::size_t s = 0; s < swarms.size(); ++s) {
    if (!swarms[s].is_guided()) {
      world.costs.push_back(nullptr);
      continue;
    }
    std::size_t same = 0;
    while (same < s && !share_cost(scenario_, swarms[same], swarms[s])) {
      ++same;
    }
    const std::size_t changing = world.solver ? world.solver->cost_of(s) : FieldSolver::kNone;
    if (same < s) {
      world.costs.push_back(world.costs[same]);
    } else {
      world.costs.push_back(changing == FieldSolver::kNone ? make_cost(world, swarms[s]) : first_[changing]);
    }
    if (same == s && world.costs[s] != nullptr) {
      if (std::string text = fields::describe_unreachable(*world.costs[s], swarms[s].goal); !text.empty()) {
        const GoalSpec& goal = scenario_.world.goals[goal_index(scenario_, swarms[s])];
        world.warnings.push_back({.message = std::move(text), .place = goal.place});
      }
    }
  }
  world.preprocessing.cost_cached = cached_;
  world.preprocessing.cost += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(errors_);
}

// The first set is flown by until the second is there, a period later; it knows of no crowd.
void WorldCosts::solve_changing(World& world) {
  cached_ = false;
  auto solver = FieldSolver::make(scenario_, world.distance, threads_);
  if (!solver) {
    errors_.push_back(std::move(solver.error()));
    return;
  }
  FieldSet set = solver->make_set();
  if (auto solved = solver->solve({.until_s = set_duration(scenario_)}, threads_, set); !solved) {
    errors_.push_back(std::move(solved.error()));
    return;
  }
  for (std::size_t s = 0; s < scenario_.swarms.size(); ++s) {
    const std::size_t cost = solver->cost_of(s);
    if (cost != FieldSolver::kNone && set.lost[cost]) {
      refuse(std::move(*set.lost[cost]), scenario_.swarms[s]);
      set.lost[cost].reset();
    }
  }
  for (fields::CostField& cost : set.costs) {
    first_.push_back(std::make_shared<const fields::CostField>(std::move(cost)));
  }
  if (solver->walls_change()) {
    world.walls = std::move(set.walls);
  }
  world.solver = std::make_shared<FieldSolver>(std::move(*solver));
}

WorldCosts::CostField WorldCosts::make_cost(const World& world, const SwarmSpec& swarm) {
  auto field = load_or_solve(world, swarm);
  if (!field) {
    refuse(std::move(field.error()), swarm);
    return nullptr;
  }
  return std::make_shared<const fields::CostField>(std::move(*field));
}

void WorldCosts::refuse(Error error, const SwarmSpec& swarm) {
  error.message = "goal '" + swarm.goal + "': " + error.message;
  if (!error.place) {
    error.place = scenario_.world.goals[goal_index(scenario_, swarm)].place;
  }
  errors_.push_back(std::move(error));
}

Result<fields::CostField> WorldCosts::load_or_solve(const World& world, const SwarmSpec& swarm) {
  if (world.nested) {
    cached_ = false;
    return fields::build_nested_cost({world.nested, world.distance.distance},
                                     world.goals[goal_index(scenario_, swarm)], cost_params(swarm), threads_,
                                     progress_);
  }
  const GoalSpec& goal = scenario_.world.goals[goal_index(scenario_, swarm)];
  auto region = fields::build_goal_distance({goal.shape, goal.place}, world.grid, threads_, progress_);
  if (!region) {
    return fail(std::move(region.error()));
  }
  const fields::CostParams params = cost_params(swarm);
  std::vector<float> extra;
  if (const auto brushes = cost_brushes(scenario_, swarm); !brushes.empty()) {
    extra.resize(world.grid.size());
    if (auto painted = fields::add_brushes(brushes, world.grid, extra); !painted) {
      return fail(std::move(painted.error()));
    }
  }
  const fields::CostTerms terms{extra};
  const std::string key = fields::cost_key(world.distance, *region, params, terms);
  if (auto kept = cache_.load(key, 4 * world.grid.size())) {
    return fields::restore_cost_field(world.distance, params, std::move(*kept));
  }
  cached_ = false;
  auto field = fields::build_cost_field(world.distance, *region, params, threads_, progress_, terms);
  if (field) {
    cache_.store(key, field->guide);
  }
  return field;
}

}  // namespace mayfly
