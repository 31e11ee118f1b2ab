// A goal that may move: its shape, checked once, and its distance where it is now.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/grid.hpp"
#include "core/result.hpp"
#include "fields/geometry.hpp"
#include "fields/goal.hpp"
#include "fields/sample_distance.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

class GoalRegion {
 public:
  // Errors: those of Geometry::make.
  static Result<GoalRegion> make(const PlacedShape& shape, const Grid& grid);

  const Geometry& geometry() const noexcept { return geometry_; }

  // A goal's distance without a goal: kNoObstacle everywhere.
  GoalDistance nowhere() const;
  // Writes the distance to the goal, displaced by `offset` (m), into the cells near it, where place_sources
  // asks for it; all others stay or become kNoObstacle. `goal` comes from nowhere() or from here. For
  // primitives it asks for no memory.
  void move(glm::vec3 offset, int threads, GoalDistance& goal);

  // The shape's middle at `offset`, where that lies inside or less than a cell from it.
  std::optional<glm::vec3> middle(glm::vec3 offset) const noexcept;

 private:
  GoalRegion(Geometry geometry, const PlacedShape& shape, const Grid& grid);

  Geometry geometry_;
  Grid grid_;
  Place place_;
  std::optional<glm::vec3> middle_;
  CellBox written_;
};

}  // namespace mayfly::fields
