// Inside or outside, by counting the triangles that a line along x crosses, with their direction.
//
// The winding number of a closed surface at p is the sum of the crossings at smaller x: +1 where the line
// enters through a triangle, −1 where it leaves. Unlike the sign of the nearest triangle's normal it is right
// for cavities, for parts that nest or overlap, and where four triangles share an edge. A line that hits an
// edge or a vertex is counted once: each edge decides on which side of it the line passes from its own two
// ends in a fixed order, so all triangles that share the edge agree.
#pragma once

#include <glm/vec3.hpp>

namespace mayfly::fields {

namespace detail {

// +1 or −1 where the edge a → b, seen along x, passes the line through (y, z) on its +y side upwards or
// downwards in z; else 0. Summed over a triangle's edges, that is the triangle's winding about the line.
inline int edge_passes(const glm::dvec3& a, const glm::dvec3& b, double y, double z) {
  if ((a.z <= z) == (b.z <= z)) {
    return 0;
  }
  const bool up = a.z < b.z;
  const glm::dvec3& low = up ? a : b;
  const glm::dvec3& high = up ? b : a;
  const bool left = (high.y - low.y) * (z - low.z) - (y - low.y) * (high.z - low.z) > 0.0;
  return left ? (up ? 1 : -1) : 0;
}

}  // namespace detail

// What crossing triangle abc in +x direction at (y, z) adds to the winding number: 0 where the line misses
// it.
inline int crossing(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double y, double z) {
  // A triangle that faces +x runs counter-clockwise in the y-z plane: the line leaves the solid there.
  return -(detail::edge_passes(a, b, y, z) + detail::edge_passes(b, c, y, z) +
           detail::edge_passes(c, a, y, z));
}

// Where the line through (y, z) meets the plane of abc; kept within the triangle, as its plane may hold the
// line.
double crossing_x(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double y, double z);

}  // namespace mayfly::fields
