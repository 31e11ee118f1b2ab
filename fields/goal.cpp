#include "fields/goal.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace mayfly::fields {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::optional<glm::vec3> middle_of(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) {
    return 0.5F * (box->box.min + box->box.max);
  }
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return sphere->center;
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) {
    return 0.5F * (cylinder->from + cylinder->to);
  }
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    return mesh->position;
  }
  return std::nullopt;
}

tl::unexpected<Error> goal_error(const GoalDistance& goal, std::string message, std::string found = {}) {
  Error error{Cause::kCaller, std::move(message)};
  if (!goal.place.file.empty()) {
    error.place = goal.place;
  }
  error.found = std::move(found);
  return fail(std::move(error));
}

// The free cells that are joined to `first` by free cells less than `reach` (m) from the goal.
void flood(const DistanceField& obstacles, const GoalDistance& goal, float clearance, float reach,
           std::size_t first, std::span<float> cost) {
  const glm::ivec3 n = goal.grid.cells;
  const auto nx = static_cast<std::size_t>(n.x);
  const auto plane = nx * static_cast<std::size_t>(n.y);
  std::vector<std::size_t> open{first};
  cost[first] = goal.distance[first];
  const auto visit = [&](std::size_t cell) {
    if (cost[cell] == kInfinity && obstacles.distance[cell] >= clearance && goal.distance[cell] <= reach) {
      cost[cell] = goal.distance[cell];
      open.push_back(cell);
    }
  };
  while (!open.empty()) {
    const std::size_t cell = open.back();
    open.pop_back();
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
                                         const Progress& progress) {
  const auto geometry = Geometry::make({&shape, 1}, grid.cell);
  if (!geometry) {
    return fail(geometry.error());
  }
  auto field = build_distance_field(*geometry, grid, threads, progress);
  if (!field) {
    return fail(std::move(field.error()));
  }
  GoalDistance goal{grid, std::move(field->distance), middle_of(shape.shape), shape.place};
  if (goal.middle && geometry->signed_distance(*goal.middle) > grid.cell) {
    goal.middle.reset();
  }
  return goal;
}

Result<bool> place_sources(const DistanceField& obstacles, const GoalDistance& goal, float clearance,
                           std::span<float> cost) {
  const std::size_t count = obstacles.grid.size();
  if (goal.grid.cells != obstacles.grid.cells || goal.distance.size() != count ||
      obstacles.distance.size() != count || cost.size() != count) {
    return goal_error(goal, "the goal and the obstacles are sampled on different grids");
  }
  bool any_source = false;
  std::size_t nearest = 0;  // of all cells
  std::size_t nearest_free = count;
  for (std::size_t cell = 0; cell < count; ++cell) {
    const float depth = goal.distance[cell];
    const float wall = obstacles.distance[cell];
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
    return false;
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
  flood(obstacles, goal, clearance, 1.5F * cell_side, nearest_free, cost);
  return true;
}

}  // namespace mayfly::fields
