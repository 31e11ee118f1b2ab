#include "controller/flight/nested_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "controller/flight/field_margin.hpp"

namespace mayfly {
namespace {

// Fine cells of a wall's inside that lead out of it, and beside a goal's surface.
constexpr float kInside = 2.0F;
constexpr float kGoal = 3.0F;

Error refusal(std::string what, const Place& place) {
  return {.message = std::move(what) + ": not on a nested grid in this version",
          .place = place,
          .suggestion = "leave out coarse_cell, with a larger cell if the grid is then too large"};
}

}  // namespace

std::vector<Error> nested_refusals(const Scenario& scenario) {
  std::vector<Error> errors;
  const WorldSpec& world = scenario.world;
  const float wanted = world.cell * static_cast<float>(NestedGrid::kRatio);
  if (std::fabs(*world.coarse_cell - wanted) > 1e-4F * wanted) {
    errors.push_back(
        {.message = fmt::format("a coarse cell is {} cells wide", NestedGrid::kRatio),
         .found = fmt::format("coarse_cell {:g} m with cells of {:g} m", *world.coarse_cell, world.cell),
         .wanted = fmt::format("coarse_cell: {:g}", wanted)});
  }
  for (const ObstacleSpec& obstacle : world.obstacles) {
    if (obstacle.path) {
      errors.push_back(refusal("an obstacle that moves", obstacle.place));
    }
  }
  for (const GoalSpec& goal : world.goals) {
    if (goal.path) {
      errors.push_back(refusal("a goal that moves", goal.place));
    }
  }
  for (const BrushSpec& brush : world.brushes) {
    if (brush.term == BrushSpec::Term::kCost) {
      errors.push_back(refusal("a brush of costs", brush.place));
    }
  }
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (swarm.cost.density_weight > 0.0F) {
      errors.push_back(refusal("swarm '" + swarm.name + "': density_weight", swarm.place));
    }
  }
  return errors;
}

Result<fields::NestedDistance> make_nested_distance(const Scenario& scenario, const fields::Geometry& solid,
                                                    std::span<const fields::Geometry> goals, int threads,
                                                    const Progress& progress) {
  const float cell = scenario.world.cell;
  const std::vector<float> lengths = wall_lengths(scenario, Grid{.cell = cell});
  const fields::BrickReach reach{*std::ranges::max_element(lengths) + cell, kInside * cell, kGoal * cell};
  return fields::build_nested_distance(solid, goals, scenario.world.bounds, cell, reach, threads, progress);
}

}  // namespace mayfly
