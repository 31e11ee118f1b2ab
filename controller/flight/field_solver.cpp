#include "controller/flight/field_solver.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <system_error>
#include <utility>

#include "controller/flight/field_margin.hpp"
#include "controller/flight/swarm_cost.hpp"

namespace mayfly {
namespace {

// Nobody is led anywhere by such a field.
void lose_the_way(fields::CostField& field) {
  for (std::size_t cell = 0; cell < field.kind.size(); ++cell) {
    std::fill_n(field.guide.begin() + static_cast<std::ptrdiff_t>(4 * cell), 3, 0.0F);
    field.guide[4 * cell + 3] = fields::kUnreachableGuide;
    field.kind[cell] = fields::CellKind::kUnreachable;
  }
}

bool is_cut_off(const fields::CostField& field, float x, float y, float z) {
  const glm::vec3 at = (glm::vec3(x, y, z) - field.grid.origin) / field.grid.cell;
  const auto n = glm::vec3(field.grid.cells);
  // Negated: whoever is nowhere is not counted.
  if (!(at.x >= 0.0F && at.y >= 0.0F && at.z >= 0.0F && at.x < n.x && at.y < n.y && at.z < n.z)) {
    return false;
  }
  const glm::ivec3 cell(at);
  return field.kind[field.grid.index(cell.x, cell.y, cell.z)] == fields::CellKind::kUnreachable;
}

}  // namespace

Result<FieldSolver> FieldSolver::make(const Scenario& scenario, const fields::DistanceField& still,
                                      int threads) try {
  FieldSolver solver(scenario);
  solver.grid_ = still.grid;
  solver.still_ = still.distance;
  if (auto added = solver.add_obstacles(still, threads); !added) {
    return fail(std::move(added.error()));
  }
  if (auto added = solver.add_costs(); !added) {
    return fail(std::move(added.error()));
  }
  return solver;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for fields that are solved in flight");
}

Result<void> FieldSolver::add_obstacles(const fields::DistanceField& still, int threads) {
  std::vector<fields::PlacedShape> shapes;
  float widest = 0.0F;
  for (std::size_t i = 0; i < scenario_.world.obstacles.size(); ++i) {
    const ObstacleSpec& obstacle = scenario_.world.obstacles[i];
    if (obstacle.path) {
      shapes.push_back({obstacle.shape, obstacle.place});
      moving_.push_back(i);
      widest = std::max(widest, obstacle_margin(scenario_, *obstacle.path, 0.0, set_duration(scenario_)));
    }
  }
  if (shapes.empty()) {
    return {};
  }
  offsets_.resize(shapes.size());
  margins_.resize(shapes.size());
  const std::vector<float> lengths = wall_lengths(scenario_, grid_);
  auto obstacles =
      fields::MovingObstacles::make(still, shapes, fields::reach_for(lengths, grid_) + widest, threads);
  if (!obstacles) {
    return fail(std::move(obstacles.error()));
  }
  obstacles_ = std::move(*obstacles);
  return {};
}

Result<void> FieldSolver::add_costs() {
  const auto& swarms = scenario_.swarms;
  for (std::size_t s = 0; s < swarms.size(); ++s) {
    std::size_t same = 0;
    while (same < s && !share_cost(scenario_, swarms[same], swarms[s])) {
      ++same;
    }
    if (same < s || !swarms[s].is_guided() || !changes_in_flight(scenario_, swarms[s])) {
      cost_of_.push_back(same < s ? cost_of_[same] : kNone);
      continue;
    }
    const std::size_t goal = goal_index(scenario_, swarms[s]);
    const GoalSpec& spec = scenario_.world.goals[goal];
    auto solver = fields::CostSolver::make(grid_, {spec.shape, spec.place}, cost_params(swarms[s]));
    if (!solver) {
      return fail(std::move(solver.error()));
    }
    Cost cost{std::move(*solver), goal, swarms[s].cost.density_weight, {}, {}};
    if (const auto brushes = cost_brushes(scenario_, swarms[s]); !brushes.empty()) {
      cost.brushes.resize(grid_.size());
      if (auto painted = fields::add_brushes(brushes, grid_, cost.brushes); !painted) {
        return painted;
      }
      cost.extra = cost.brushes;
    }
    if (cost.density_weight > 0.0F) {
      cost.extra.resize(grid_.size());
      density_.resize(grid_.size());
    }
    cost_of_.push_back(costs_.size());
    costs_.push_back(std::move(cost));
  }
  return {};
}

FieldSet FieldSolver::make_set() const {
  FieldSet set;
  set.walls.resize(walls_change() ? grid_.size() : 0);
  for (const Cost& cost : costs_) {
    set.costs.push_back(cost.solver.make_field());
  }
  set.lost.resize(costs_.size());
  set.cut_off.resize(cost_of_.size());
  return set;
}

Result<void> FieldSolver::solve(const FieldInputs& inputs, int threads, FieldSet& set) try {
  const auto start = std::chrono::steady_clock::now();
  set.time_s = inputs.time_s;
  auto done = move_obstacles(inputs, threads, set).and_then([&] { return gather_density(inputs); });
  const double middle = 0.5 * (inputs.from_s + inputs.until_s);
  for (std::size_t c = 0; done && c < costs_.size(); ++c) {
    const auto& path = scenario_.world.goals[costs_[c].goal].path;
    done = solve_cost(c, path ? path->displacement(middle) : glm::vec3(0.0F), threads, set);
  }
  if (done) {
    find_cut_off(inputs, set);
  }
  set.solve_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory to solve a field");
} catch (const std::system_error& error) {
  return fail(Cause::kEnvironment, std::string("no thread to solve a field: ") + error.what());
}

Result<void> FieldSolver::move_obstacles(const FieldInputs& inputs, int threads, FieldSet& set) {
  if (!obstacles_) {
    return {};
  }
  const double middle = 0.5 * (inputs.from_s + inputs.until_s);
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const PathSpec& path = *scenario_.world.obstacles[moving_[i]].path;
    offsets_[i] = path.displacement(middle);
    margins_[i] = obstacle_margin(scenario_, path, inputs.from_s, inputs.until_s);
  }
  return obstacles_->move(offsets_, margins_, threads).map([&] {
    const std::span<const float> walls = obstacles_->walls();
    std::copy(walls.begin(), walls.end(), set.walls.begin());
  });
}

Result<void> FieldSolver::gather_density(const FieldInputs& inputs) {
  if (density_.empty()) {
    return {};
  }
  return fields::bin_density(inputs.x, inputs.y, inputs.z, grid_, density_).and_then([&]() -> Result<void> {
    for (Cost& cost : costs_) {
      if (cost.density_weight <= 0.0F) {
        continue;
      }
      if (cost.brushes.empty()) {
        std::fill(cost.extra.begin(), cost.extra.end(), 0.0F);
      } else {
        std::copy(cost.brushes.begin(), cost.brushes.end(), cost.extra.begin());
      }
      if (auto added = fields::add_density(cost.density_weight, density_, cost.extra); !added) {
        return added;
      }
    }
    return {};
  });
}

Result<void> FieldSolver::solve_cost(std::size_t cost, glm::vec3 goal_offset, int threads, FieldSet& set) {
  Cost& own = costs_[cost];
  const std::span<const float> distance = obstacles_ ? obstacles_->field().distance : still_;
  auto solved = own.solver.solve({distance, goal_offset, {own.extra}}, threads, set.costs[cost]);
  set.lost[cost].reset();
  if (!solved) {
    if (solved.error().cause != Cause::kCaller) {
      return fail(std::move(solved.error()));
    }
    set.lost[cost] = std::move(solved.error());
    lose_the_way(set.costs[cost]);
  }
  return {};
}

void FieldSolver::find_cut_off(const FieldInputs& inputs, FieldSet& set) const {
  std::size_t first = 0;
  for (std::size_t s = 0; s < cost_of_.size(); ++s) {
    const std::size_t end = first + static_cast<std::size_t>(scenario_.swarms[s].count);
    set.cut_off[s] = 0;
    for (std::size_t a = first; cost_of_[s] != kNone && a < std::min(end, inputs.x.size()); ++a) {
      set.cut_off[s] += is_cut_off(set.costs[cost_of_[s]], inputs.x[a], inputs.y[a], inputs.z[a]) ? 1U : 0U;
    }
    first = end;
  }
}

}  // namespace mayfly
