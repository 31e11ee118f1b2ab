#include "controller/flight/world.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "controller/flight/kernel_parts.hpp"
#include "fields/cache.hpp"
#include "fields/goal.hpp"
#include "fields/make_grid.hpp"
#include "fields/spline.hpp"

namespace mayfly {
namespace {

using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

// What distinguishes one cost field from another in the same world.
using CostIdentity = std::tuple<std::string, float, float, float, float>;

fields::CostParams cost_params(const SwarmSpec& swarm) {
  return {swarm.cost.length_weight, swarm.cost.repulsion_weight, swarm.cost.influence.value_or(0.0F),
          swarm.radius};
}

// The scenario's world while it is being built: what is known so far, and what went wrong.
class Builder {
 public:
  Builder(const Scenario& scenario, int threads, const Progress& progress)
      : scenario_(scenario), threads_(threads), progress_(progress) {}

  tl::expected<World, std::vector<Error>> build() {
    auto grid = fields::make_grid(scenario_.world.bounds, scenario_.world.cell);
    auto solid = make_solid();
    auto goals = make_goals();
    if (!grid) {
      errors_.push_back(std::move(grid.error()));
    }
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    auto distance = make_distance(*solid, *grid);
    if (!distance) {
      return tl::unexpected(std::vector<Error>{std::move(distance.error())});
    }
    std::vector<float> walls = fields::spline_coefficients(*grid, distance->distance);
    World world{*grid, std::move(*solid), std::move(*distance), std::move(walls), std::move(goals), {}, {},
                {}};
    make_costs(world);
    world.preprocessing = timing_;
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    return world;
  }

 private:
  Result<fields::Geometry> make_solid() {
    const auto start = SteadyClock::now();
    std::vector<fields::PlacedShape> shapes;
    for (const ObstacleSpec& obstacle : scenario_.world.obstacles) {
      shapes.push_back({obstacle.shape, obstacle.place});
    }
    auto solid = fields::Geometry::make(shapes, scenario_.world.cell);
    if (!solid) {
      errors_.push_back(solid.error());
    }
    timing_.distance += seconds_since(start);
    return solid;
  }

  std::vector<fields::Geometry> make_goals() {
    std::vector<fields::Geometry> goals;
    for (const GoalSpec& goal : scenario_.world.goals) {
      const fields::PlacedShape shape{goal.shape, goal.place};
      auto region = fields::Geometry::make({&shape, 1}, scenario_.world.cell);
      if (region) {
        goals.push_back(std::move(*region));
      } else {
        errors_.push_back(std::move(region.error()));
      }
    }
    return goals;
  }

  Result<fields::DistanceField> make_distance(const fields::Geometry& solid, const Grid& grid) {
    const auto start = SteadyClock::now();
    const std::string key = fields::distance_key(solid, grid);
    Result<fields::DistanceField> field;
    if (auto kept = cache_.load(key, grid.size())) {
      timing_.distance_cached = true;
      field = fields::DistanceField{grid, std::move(*kept)};
    } else {
      field = fields::build_distance_field(solid, grid, threads_, progress_);
      if (field) {
        cache_.store(key, field->distance);
      }
    }
    timing_.distance += seconds_since(start);
    return field;
  }

  void make_costs(World& world) {
    std::map<CostIdentity, std::shared_ptr<const fields::CostField>> known;
    timing_.cost_cached = true;
    for (const SwarmSpec& swarm : scenario_.swarms) {
      const fields::CostParams params = cost_params(swarm);
      const CostIdentity identity{swarm.goal, params.length_weight, params.repulsion_weight, params.influence,
                                  params.clearance};
      auto& cost = known[identity];
      if (!cost) {
        cost = make_cost(world, swarm, params);
      }
      world.costs.push_back(cost);
    }
  }

  std::shared_ptr<const fields::CostField> make_cost(World& world, const SwarmSpec& swarm,
                                                     const fields::CostParams& params) {
    const auto start = SteadyClock::now();
    const auto goal = std::find_if(scenario_.world.goals.begin(), scenario_.world.goals.end(),
                                   [&](const GoalSpec& g) { return g.name == swarm.goal; });
    auto field = load_or_solve(world, *goal, params);
    timing_.cost += seconds_since(start);
    if (!field) {
      Error error = std::move(field.error());
      error.message = "goal '" + swarm.goal + "': " + error.message;
      if (!error.place) {
        error.place = goal->place;
      }
      errors_.push_back(std::move(error));
      return nullptr;
    }
    if (std::string text = fields::describe_unreachable(*field, swarm.goal); !text.empty()) {
      Error warning;
      warning.message = std::move(text);
      warning.place = goal->place;
      world.warnings.push_back(std::move(warning));
    }
    return std::make_shared<const fields::CostField>(std::move(*field));
  }

  Result<fields::CostField> load_or_solve(const World& world, const GoalSpec& goal,
                                          const fields::CostParams& params) {
    auto region = fields::build_goal_distance({goal.shape, goal.place}, world.grid, threads_, progress_);
    if (!region) {
      return fail(std::move(region.error()));
    }
    const std::string key = fields::cost_key(world.distance, *region, params);
    if (auto kept = cache_.load(key, 4 * world.grid.size())) {
      return fields::restore_cost_field(world.distance, params, std::move(*kept));
    }
    timing_.cost_cached = false;
    auto field = fields::build_cost_field(world.distance, *region, params, threads_, progress_);
    if (field) {
      cache_.store(key, field->guide);
    }
    return field;
  }

  const Scenario& scenario_;
  int threads_;
  const Progress& progress_;
  fields::FieldCache cache_;
  PreprocessingSummary timing_;
  std::vector<Error> errors_;
};

}  // namespace

tl::expected<World, std::vector<Error>> build_world(const Scenario& scenario, int threads,
                                                    const Progress& progress) {
  if (auto errors = excess_pulls(scenario); !errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return Builder(scenario, threads, progress).build();
}

}  // namespace mayfly
