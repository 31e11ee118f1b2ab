#include "fields/goal_region.hpp"

#include <algorithm>
#include <utility>

#include "fields/geometry_parts.hpp"

namespace mayfly::fields {
namespace {

// Cells beyond this from a goal (in cell sides) never become its sources.
constexpr float kSourceReach = 1.5F;

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

}  // namespace

GoalRegion::GoalRegion(Geometry geometry, const PlacedShape& shape, const Grid& grid)
    : geometry_(std::move(geometry)), grid_(grid), place_(shape.place), middle_(middle_of(shape.shape)) {
  if (middle_ && geometry_.signed_distance(*middle_) > grid.cell) {
    middle_.reset();
  }
}

Result<GoalRegion> GoalRegion::make(const PlacedShape& shape, const Grid& grid) {
  auto geometry = Geometry::make({&shape, 1}, grid.cell);
  if (!geometry) {
    return fail(std::move(geometry.error()));
  }
  return GoalRegion(std::move(*geometry), shape, grid);
}

GoalDistance GoalRegion::nowhere() const {
  return {grid_, std::vector<float>(grid_.size(), kNoObstacle), std::nullopt, place_};
}

std::optional<glm::vec3> GoalRegion::middle(glm::vec3 offset) const noexcept {
  return middle_ ? std::optional(*middle_ + offset) : std::nullopt;
}

void GoalRegion::move(glm::vec3 offset, int threads, GoalDistance& goal) {
  fill_box(grid_, written_, kNoObstacle, goal.distance);
  written_ = {glm::ivec3(0), grid_.cells};
  if (const std::optional<Box> bounds = geometry_.parts().bounds()) {
    written_ = cells_around({bounds->min + offset, bounds->max + offset}, kSourceReach * grid_.cell, grid_);
  }
  lower_to_distance(geometry_, {grid_, written_, glm::dvec3(offset)}, threads, {}, goal.distance);
  goal.middle = middle(offset);
}

}  // namespace mayfly::fields
