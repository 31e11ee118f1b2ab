// The solid world, exactly: obstacles as world-space triangles and primitives, not as cells.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/result.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

// The distance that a world without obstacles reports everywhere, m: finite, so that arithmetic on it stays
// finite.
inline constexpr float kNoObstacle = 1e9F;

struct PlacedShape {
  Shape shape;
  Place place;  // where the scenario names it, for errors
};

// A union of shapes: φ = min over shapes of each shape's signed distance (model.md §2), negative inside, in
// m, world frame. A closed mesh is solid where its winding number is not zero, so cavities, nested and
// overlapping parts come out right. A thin mesh is a shell: |d| − thickness/2. Queries are const, allocate
// nothing, and may run on any number of threads.
class Geometry {
 public:
  // Loads, transforms and checks every shape. Errors carry the shape's place: a mesh that cannot be read, one
  // that is open and not marked thin (its holes are named), a primitive without extent. `default_thickness`,
  // m: of thin meshes that do not say; one cell, by custom.
  static Result<Geometry> make(std::span<const PlacedShape> shapes, float default_thickness);

  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) noexcept;
  ~Geometry();

  // kNoObstacle where there is no shape at all.
  float signed_distance(glm::vec3 point) const noexcept;
  bool contains(glm::vec3 point) const noexcept;

  bool empty() const noexcept;
  // The box (m) that holds every shape, thick shells included. Nothing where there is no shape, and with a
  // half-space among them.
  std::optional<Box> bounds() const noexcept;
  std::size_t triangle_count() const noexcept;
  // 32 hex digits that change with any vertex, triangle, thickness or primitive: the world-space content, not
  // file names.
  const std::string& content_hash() const noexcept;

  struct Parts;  // fields/geometry_parts.hpp, for those who build fields
  const Parts& parts() const noexcept { return *parts_; }

 private:
  explicit Geometry(std::unique_ptr<const Parts> parts) noexcept;

  std::unique_ptr<const Parts> parts_;
};

}  // namespace mayfly::fields
