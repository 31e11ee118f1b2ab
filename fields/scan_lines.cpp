#include "fields/scan_lines.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace mayfly::fields {

double crossing_x(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double y, double z) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double low = std::min({a.x, b.x, c.x});
  const double high = std::max({a.x, b.x, c.x});
  if (normal.x == 0.0) {
    return low;
  }
  return std::clamp(a.x - (normal.y * (y - a.y) + normal.z * (z - a.z)) / normal.x, low, high);
}

}  // namespace mayfly::fields
