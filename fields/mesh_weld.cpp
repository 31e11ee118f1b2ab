#include "fields/mesh_weld.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace mayfly::fields {
namespace {

constexpr double kTolerance = 1e-6;  // of the bounding box's diagonal

// A direction along which modelled vertices hardly ever share a place, as they do along the axes.
const glm::dvec3 kSkew = glm::normalize(glm::dvec3(0.5712, 0.6731, 0.4697));

// result[i]: the vertex that i becomes. Sorted along a line, only a short run of vertices can be near enough.
std::vector<glm::uint> representatives(const std::vector<glm::vec3>& vertices) {
  glm::vec3 low = vertices[0];
  glm::vec3 high = vertices[0];
  for (const glm::vec3& v : vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const double tolerance = kTolerance * glm::length(glm::dvec3(high) - glm::dvec3(low));
  std::vector<double> along(vertices.size());
  std::ranges::transform(vertices, along.begin(),
                         [](const glm::vec3& v) { return glm::dot(glm::dvec3(v), kSkew); });
  std::vector<glm::uint> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(
      order, [&](glm::uint a, glm::uint b) { return along[a] != along[b] ? along[a] < along[b] : a < b; });
  std::vector<glm::uint> found(vertices.size());
  std::vector<glm::uint> kept;
  for (const glm::uint i : order) {
    found[i] = i;
    for (auto k = kept.rbegin(); k != kept.rend() && along[i] - along[*k] <= tolerance; ++k) {
      if (glm::distance(glm::dvec3(vertices[i]), glm::dvec3(vertices[*k])) <= tolerance) {
        found[i] = *k;
        break;
      }
    }
    if (found[i] == i) {
      kept.push_back(i);
    }
  }
  return found;
}

}  // namespace

void weld(TriangleMesh& mesh) {
  const std::vector<glm::uint> same = representatives(mesh.vertices);
  std::vector<glm::uint> renamed(mesh.vertices.size(), ~glm::uint{0});
  TriangleMesh welded;
  const auto corner = [&](glm::uint i) {
    glm::uint& name = renamed[same[i]];
    if (name == ~glm::uint{0}) {
      name = static_cast<glm::uint>(welded.vertices.size());
      welded.vertices.push_back(mesh.vertices[same[i]]);
    }
    return name;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    if (same[t.x] != same[t.y] && same[t.y] != same[t.z] && same[t.z] != same[t.x]) {
      const glm::uint a = corner(t.x);
      const glm::uint b = corner(t.y);
      welded.triangles.emplace_back(a, b, corner(t.z));
    }
  }
  mesh = std::move(welded);
}

}  // namespace mayfly::fields
