// Polygons into triangles.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace mayfly::fields {

inline constexpr std::size_t kMaxCorners = 4096;  // the work grows with their square

// Cuts a polygon, flat or nearly so, convex or not, into corners − 2 triangles of its own vertices and
// winding, by cutting off ears. `corners` are indices of `vertices`; 3 to kMaxCorners of them.
std::vector<glm::uvec3> triangulate(std::span<const glm::uint> corners, std::span<const glm::vec3> vertices);

}  // namespace mayfly::fields
