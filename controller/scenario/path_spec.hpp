// A way through the world that something follows by a script.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/grid.hpp"
#include "core/result.hpp"

namespace mayfly {

// How a shape moves: in straight lines from point to point at one speed. The shape is given where it is at
// the start; at a later time it is displaced by where the path has got to, less the path's first point.
struct PathSpec {
  std::vector<glm::vec3> points;  // m, at least two, not all the same
  float speed = 1.0F;             // m/s
  // From the last point straight back to the first, for ever; otherwise the shape stays at the last.
  bool loop = false;
  Place place;

  // m, at `time_s` after the start (s; the first point before it). Allocates nothing.
  glm::vec3 displacement(double time_s) const noexcept;
  // m/s, of the displacement; zero where it has come to its end.
  glm::vec3 velocity(double time_s) const noexcept;
  // The first of the points at which a shape, `shape` at the start, does not lie inside `bounds`. Between two
  // points that lie inside it does as well.
  std::optional<std::size_t> first_point_outside(const Box& shape, const Box& bounds) const;
};

}  // namespace mayfly
