#include "controller/flight/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "controller/flight/kernel_parts.hpp"
#include "controller/flight/nested_world.hpp"
#include "controller/flight/world_costs.hpp"
#include "fields/cache.hpp"
#include "fields/careful_walls.hpp"
#include "fields/make_grid.hpp"
#include "fields/spline.hpp"

namespace mayfly {
namespace {

using SteadyClock = std::chrono::steady_clock;

double seconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

// The scenario's world while it is being built: what is known so far, and what went wrong.
class Builder {
 public:
  Builder(const Scenario& scenario, int threads, const Progress& progress, const fields::FieldCache& cache)
      : scenario_(scenario), threads_(threads), progress_(progress), cache_(cache) {}

  tl::expected<World, std::vector<Error>> build() {
    if (scenario_.world.coarse_cell) {
      return build_nested();
    }
    auto grid = fields::make_grid(scenario_.world.bounds, scenario_.world.cell);
    auto solid = make_solid();
    auto moving = make_moving_bodies(scenario_, threads_);
    auto goals = make_goals();
    if (!grid) {
      errors_.push_back(std::move(grid.error()));
    }
    if (!moving) {
      errors_.insert(errors_.end(), moving.error().begin(), moving.error().end());
    }
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    auto distance = make_distance(*solid, *grid);
    if (!distance) {
      return tl::unexpected(std::vector<Error>{std::move(distance.error())});
    }
    std::vector<float> walls = make_walls(*solid, *distance);
    World world{.grid = *grid,
                .nested = nullptr,
                .solid = std::move(*solid),
                .distance = std::move(*distance),
                .moving = std::move(*moving),
                .walls = std::move(walls),
                .goals = std::move(goals),
                .costs = {},
                .solver = nullptr,
                .preprocessing = timing_,
                .warnings = {}};
    errors_ = WorldCosts(scenario_, threads_, progress_, cache_).add_to(world);
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    return world;
  }

 private:
  tl::expected<World, std::vector<Error>> build_nested() {
    errors_ = nested_refusals(scenario_);
    auto solid = make_solid();
    auto goals = make_goals();
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    const auto start = SteadyClock::now();
    auto field = make_nested_distance(scenario_, *solid, goals, threads_, progress_);
    if (!field) {
      return tl::unexpected(std::vector<Error>{std::move(field.error())});
    }
    std::vector<float> walls = fields::nested_walls(*field, threads_, progress_);
    timing_.distance += seconds_since(start);
    const Grid fine = field->nested.fine();
    World world{.grid = fine,
                .nested = std::make_shared<const NestedGrid>(std::move(field->nested)),
                .solid = std::move(*solid),
                .distance = {fine, std::move(field->distance)},
                .moving = {},
                .walls = std::move(walls),
                .goals = std::move(goals),
                .costs = {},
                .solver = nullptr,
                .preprocessing = timing_,
                .warnings = {}};
    errors_ = WorldCosts(scenario_, threads_, progress_, cache_).add_to(world);
    if (!errors_.empty()) {
      return tl::unexpected(std::move(errors_));
    }
    return world;
  }

  Result<fields::Geometry> make_solid() {
    const auto start = SteadyClock::now();
    std::vector<fields::PlacedShape> shapes;
    for (const ObstacleSpec& obstacle : scenario_.world.obstacles) {
      if (!obstacle.path) {
        shapes.push_back({obstacle.shape, obstacle.place});
      }
    }
    auto solid = fields::Geometry::make(shapes, scenario_.world.cell);
    if (!solid) {
      errors_.push_back(solid.error());
    }
    timing_.distance += seconds_since(start);
    return solid;
  }

  std::vector<float> make_walls(const fields::Geometry& solid, const fields::DistanceField& distance) {
    const auto start = SteadyClock::now();
    std::vector<float> walls(distance.distance.size());
    fields::fill_spline_coefficients(distance.grid, distance.distance, threads_, walls);
    fields::lower_walls(solid, distance, threads_, walls);
    timing_.distance += seconds_since(start);
    return walls;
  }

  std::vector<fields::Geometry> make_goals() {
    std::vector<fields::Geometry> goals;
    for (const GoalSpec& goal : scenario_.world.goals) {
      const fields::PlacedShape shape{goal.shape, goal.place};
      auto region = fields::Geometry::make({&shape, 1}, scenario_.world.cell);
      if (region) {
        check_path(goal, *region);
        goals.push_back(std::move(*region));
      } else {
        errors_.push_back(std::move(region.error()));
      }
    }
    return goals;
  }

  // The loader has looked at boxes and spheres; how far a mesh reaches is known only now.
  void check_path(const GoalSpec& goal, const fields::Geometry& region) {
    const std::optional<Box> shape = region.bounds();
    if (!goal.path || !shape) {
      return;
    }
    if (const auto outside = goal.path->first_point_outside(*shape, scenario_.world.bounds)) {
      errors_.push_back({.message = fmt::format("goal '{}' leaves world.bounds on its path", goal.name),
                         .place = goal.path->place,
                         .found = fmt::format("at its point number {}", *outside + 1),
                         .wanted = "points at which the whole goal lies inside"});
    }
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

  const Scenario& scenario_;
  int threads_;
  const Progress& progress_;
  const fields::FieldCache& cache_;
  PreprocessingSummary timing_;
  std::vector<Error> errors_;
};

}  // namespace

float distance_at_start(const World& world, glm::vec3 p) noexcept {
  float distance = world.solid.signed_distance(p);
  for (const MovingBody& body : world.moving) {
    distance = std::min(distance, body.solid.signed_distance(p) - body.start_margin);
  }
  return distance;
}

tl::expected<World, std::vector<Error>> build_world(const Scenario& scenario, int threads,
                                                    const Progress& progress,
                                                    const fields::FieldCache& cache) {
  if (auto errors = excess_pulls(scenario); !errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return Builder(scenario, threads, progress, cache).build();
}

}  // namespace mayfly
