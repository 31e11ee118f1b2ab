#include "fields/polygon.hpp"

#include <glm/geometric.hpp>

namespace mayfly::fields {
namespace {

// Newell's: twice the area, along the normal; right for polygons that are not quite flat.
glm::dvec3 area_vector(std::span<const glm::uint> corners, std::span<const glm::vec3> vertices) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin(vertices[corners[0]]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(glm::dvec3(vertices[corners[i]]) - origin,
                      glm::dvec3(vertices[corners[(i + 1) % corners.size()]]) - origin);
  }
  return sum;
}

double turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& normal) {
  return glm::dot(glm::cross(b - a, c - a), normal);
}

bool is_ear(std::span<const glm::uint> ring, std::size_t tip, std::span<const glm::vec3> vertices,
            const glm::dvec3& normal) {
  const std::size_t before = (tip + ring.size() - 1) % ring.size();
  const std::size_t after = (tip + 1) % ring.size();
  const glm::dvec3 a(vertices[ring[before]]);
  const glm::dvec3 b(vertices[ring[tip]]);
  const glm::dvec3 c(vertices[ring[after]]);
  if (turn(a, b, c, normal) <= 0.0) {
    return false;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const glm::dvec3 p(vertices[ring[i]]);
    // Polygons with holes pass through the same place twice: that is not inside.
    if (i != before && i != tip && i != after && p != a && p != b && p != c && turn(a, b, p, normal) >= 0.0 &&
        turn(b, c, p, normal) >= 0.0 && turn(c, a, p, normal) >= 0.0) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<glm::uvec3> triangulate(std::span<const glm::uint> corners, std::span<const glm::vec3> vertices) {
  std::vector<glm::uint> ring(corners.begin(), corners.end());
  const glm::dvec3 normal = area_vector(corners, vertices);
  std::vector<glm::uvec3> triangles;
  while (ring.size() > 3) {
    std::size_t tip = 0;
    while (tip < ring.size() && !is_ear(ring, tip, vertices, normal)) {
      ++tip;
    }
    // Without an ear the rest is a line, or crosses itself: any cut keeps the surface closed.
    tip = tip < ring.size() ? tip : 1;
    triangles.emplace_back(ring[(tip + ring.size() - 1) % ring.size()], ring[tip],
                           ring[(tip + 1) % ring.size()]);
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  triangles.emplace_back(ring[0], ring[1], ring[2]);
  return triangles;
}

}  // namespace mayfly::fields
