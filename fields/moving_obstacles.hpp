// The distance field of a world in which some obstacles move: still obstacles, and shapes that are displaced.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/grid.hpp"
#include "core/result.hpp"
#include "fields/distance_field.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// φ = min(φ_still, φ of each moving shape where it is now less its margin, reach).
//
// `reach` (m) caps the field: up to it φ is exact, and where anything is farther it says `reach`, which is a
// lower bound of the distance. So a shape that moves changes φ only within `reach` of its old and its new
// place, wherever the rest of the world is, and the field stays continuous with slopes of at most 1. Choose
// it beyond everything that asks for φ by value: the influence of the repulsion, the ramp of the noise (d0),
// the clearance and the governor's view, and two cells for the spline's support; see reach_for().
class MovingObstacles {
 public:
  // `shapes` where they are at t = 0. Meshes are loaded and checked here, once. Errors: those of
  // Geometry::make; a reach that is not a positive number; no memory. The first field is of t = 0.
  static Result<MovingObstacles> make(DistanceField still, std::span<const PlacedShape> shapes, float reach,
                                      int threads);

  MovingObstacles(MovingObstacles&&) noexcept;
  MovingObstacles& operator=(MovingObstacles&&) noexcept;
  ~MovingObstacles();

  // Puts shape i at offsets[i] (m) from where it was given, larger by margins[i] (m, ≥ 0: φ is less by that),
  // and brings field() and walls() up to date. Asks for memory for meshes and for starting threads only.
  // Errors (kCaller): another number of offsets or margins than of shapes; one that is not finite. The bits
  // do not depend on `threads` or on where the shapes were before.
  Result<void> move(std::span<const glm::vec3> offsets, std::span<const float> margins, int threads);

  const DistanceField& field() const noexcept;
  // Coefficients of the quadratic spline through field(), for the kernels (fields/spline.hpp).
  std::span<const float> walls() const noexcept;

 private:
  struct State;
  explicit MovingObstacles(std::unique_ptr<State> state) noexcept;

  std::unique_ptr<State> state_;
};

// The largest of the lengths (m) that ask for φ by value, and two cells more.
float reach_for(std::span<const float> lengths, const Grid& grid) noexcept;

}  // namespace mayfly::fields
