// What a Geometry is made of; for geometry.cpp and distance_field.cpp only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fields/geometry.hpp"
#include "fields/primitives.hpp"
#include "fields/triangle_tree.hpp"

namespace mayfly::fields {

struct Shell {
  TriangleTree tree;
  double half_thickness = 0.0;  // m
};

struct Geometry::Parts {
  std::vector<TriangleTree> solids;  // closed, each one obstacle
  std::vector<Shell> shells;
  std::vector<Primitive> primitives;
  std::size_t triangles = 0;
  std::string content_hash;

  // min over the closed meshes alone.
  double solid_distance(const glm::dvec3& point) const noexcept;
  // min over everything; kNoObstacle where there is nothing.
  double signed_distance(const glm::dvec3& point) const noexcept;
  // Of all that is not endless; nothing where something is.
  std::optional<Box> bounds() const noexcept;
};

}  // namespace mayfly::fields
