#include "fields/goal.hpp"

#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "fields/goal_region.hpp"
#include "fields/make_grid.hpp"
#include "fields/sample_distance.hpp"

namespace mayfly::fields {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

tl::unexpected<Error> goal_error(const GoalDistance& goal, std::string message, std::string found = {}) {
  Error error{Cause::kCaller, std::move(message)};
  if (!goal.place.file.empty()) {
    error.place = goal.place;
  }
  error.found = std::move(found);
  return fail(std::move(error));
}

// The free cells that are joined to `first` by free cells no farther than `reach` (m) from the goal; into
// `found`, and their distances into `cost`.
void flood(std::span<const float> obstacles, const GoalDistance& goal, float clearance, float reach,
           std::size_t first, std::span<float> cost, std::vector<std::size_t>& found) {
  const glm::ivec3 n = goal.grid.cells;
  const auto nx = static_cast<std::size_t>(n.x);
  const auto plane = nx * static_cast<std::size_t>(n.y);
  const auto visit = [&](std::size_t cell) {
    if (cost[cell] == kInfinity && obstacles[cell] >= clearance && goal.distance[cell] <= reach) {
      cost[cell] = goal.distance[cell];
      found.push_back(cell);
    }
  };
  visit(first);
  // It grows while it is read. NOLINTNEXTLINE(modernize-loop-convert)
  for (std::size_t next = 0; next < found.size(); ++next) {
    const std::size_t cell = found[next];
    const auto z = cell / plane;
    const auto y = cell % plane / nx;
    const auto x = cell % nx;
    if (x > 0) visit(cell - 1);
    if (x + 1 < nx) visit(cell + 1);
    if (y > 0) visit(cell - nx);
    if (y + 1 < static_cast<std::size_t>(n.y)) visit(cell + nx);
    if (z > 0) visit(cell - plane);
    if (z + 1 < static_cast<std::size_t>(n.z)) visit(cell + plane);
  }
}

}  // namespace

Result<GoalDistance> build_goal_distance(const PlacedShape& shape, const Grid& grid, int threads,
                                         const Progress& progress, glm::vec3 offset) try {
  const auto region = GoalRegion::make(shape, grid);
  if (!region) {
    return fail(region.error());
  }
  if (auto good = check_grid(grid); !good) {
    return fail(std::move(good.error()));
  }
  GoalDistance goal = region->nowhere();
  const SampleBox everywhere{grid, {glm::ivec3(0), grid.cells}, glm::dvec3(offset)};
  lower_to_distance(region->geometry(), everywhere, threads, progress, goal.distance);
  goal.middle = region->middle(offset);
  return goal;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for a goal's distance in " +
                                       std::to_string(grid.size()) + " cells");
}

Result<void> place_sources(std::span<const float> obstacles, const GoalDistance& goal, float clearance,
                           std::span<float> cost, std::vector<std::size_t>& small) {
  const std::size_t count = goal.grid.size();
  if (goal.distance.size() != count || obstacles.size() != count || cost.size() != count) {
    return goal_error(goal, "the goal and the obstacles are sampled on different grids");
  }
  small.clear();
  bool any_source = false;
  std::size_t nearest = 0;  // of all cells
  std::size_t nearest_free = count;
  for (std::size_t cell = 0; cell < count; ++cell) {
    const float depth = goal.distance[cell];
    const float wall = obstacles[cell];
    if (std::isnan(depth) || std::isnan(wall)) {
      return goal_error(goal, "a distance is not a number, in cell " + std::to_string(cell));
    }
    cost[cell] = kInfinity;
    if (depth < goal.distance[nearest]) {
      nearest = cell;
    }
    if (wall < clearance) {
      continue;
    }
    if (nearest_free == count || depth < goal.distance[nearest_free]) {
      nearest_free = cell;
    }
    if (depth <= 0.0F) {
      cost[cell] = depth;
      any_source = true;
    }
  }
  if (any_source) {
    return {};
  }
  const float cell_side = goal.grid.cell;
  // Half the diagonal of a cell: a goal farther than that from every centre has no point in any cell.
  if (goal.distance[nearest] > 0.8661F * cell_side) {
    return goal_error(goal, "the goal lies outside the world");
  }
  if (nearest_free == count || goal.distance[nearest_free] > cell_side) {
    return goal_error(goal, "the goal lies inside obstacles, or nearer to them than an agent can come",
                      "no free cell in it or within a cell side (" + std::to_string(cell_side) + " m) of it");
  }
  flood(obstacles, goal, clearance, 1.5F * cell_side, nearest_free, cost, small);
  return {};
}

}  // namespace mayfly::fields
