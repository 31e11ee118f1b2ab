// Distances of convex hulls, by a method that has nothing in common with the governor's: every triangle and
// every tetrahedron of the points is looked at.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

namespace mayfly::governor_test {

inline double distance_to_segment(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const glm::dvec3 way = b - a;
  const double squared = glm::dot(way, way);
  const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, way) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + t * way));
}

inline double distance_to_triangle(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const bool over = glm::dot(glm::cross(b - a, p - a), n) > 0.0 &&
                    glm::dot(glm::cross(c - b, p - b), n) > 0.0 &&
                    glm::dot(glm::cross(a - c, p - c), n) > 0.0;
  if (over) {
    return std::fabs(glm::dot(p - a, n)) / glm::length(n);
  }
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

inline bool in_tetrahedron(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  const glm::dmat3 sides(b - a, c - a, d - a);
  const double volume = glm::determinant(sides);
  if (volume == 0.0) {
    return false;
  }
  const glm::dvec3 share = glm::inverse(sides) * (p - a);
  return share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0 && share.x + share.y + share.z <= 1.0;
}

// Whether p lies in one of the tetrahedra of the triangle and a later corner.
inline bool in_any_tetrahedron(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c,
                               std::span<const glm::dvec3> later) {
  return std::any_of(later.begin(), later.end(),
                     [&](const glm::dvec3& d) { return in_tetrahedron(p, a, b, c, d); });
}

// m; 0 inside.
inline double distance_to_hull(glm::dvec3 p, std::span<const glm::dvec3> x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = i; j < x.size(); ++j) {
      for (std::size_t k = j; k < x.size(); ++k) {
        const bool inside = in_any_tetrahedron(p, x[i], x[j], x[k], x.subspan(k + 1));
        least = inside ? 0.0 : std::min(least, distance_to_triangle(p, x[i], x[j], x[k]));
      }
    }
  }
  return least;
}

}  // namespace mayfly::governor_test
