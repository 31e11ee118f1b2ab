// Distance and sign of a triangle mesh, by brute force in double precision, for tests. Written from the
// definitions, on purpose in another way than the product: vertices, edges and faces one by one, and the sign
// from angle-weighted pseudonormals (Bærentzen & Aanæs 2005, "Signed distance computation using the angle
// weighted pseudonormal") instead of crossings.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace mayfly::reference {

class MeshDistance {
 public:
  MeshDistance(const std::vector<glm::vec3>& vertices, const std::vector<glm::uvec3>& triangles)
      : vertices_(vertices.begin(), vertices.end()), triangles_(triangles), vertex_normals_(vertices.size()) {
    for (const glm::uvec3& t : triangles_) {
      const glm::dvec3 normal = face_normal(t);
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t a = t[corner];
        const std::uint32_t b = t[(corner + 1) % 3];
        const std::uint32_t c = t[(corner + 2) % 3];
        const glm::dvec3 to_b = glm::normalize(vertices_[b] - vertices_[a]);
        const glm::dvec3 to_c = glm::normalize(vertices_[c] - vertices_[a]);
        vertex_normals_[a] += std::acos(std::clamp(glm::dot(to_b, to_c), -1.0, 1.0)) * normal;
        edge_normals_[std::minmax(a, b)] += normal;
      }
    }
  }

  // Negative inside; meaningful for a closed manifold whose parts do not overlap.
  double signed_distance(const glm::dvec3& p) const {
    Nearest best;
    for (const glm::uvec3& t : triangles_) {
      face(p, t, best);
      for (int corner = 0; corner < 3; ++corner) {
        edge(p, t[corner], t[(corner + 1) % 3], best);
        vertex(p, t[corner], best);
      }
    }
    return std::copysign(best.distance, glm::dot(p - best.point, best.normal));
  }

  double distance(const glm::dvec3& p) const { return std::abs(signed_distance(p)); }

 private:
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0};
  };

  glm::dvec3 face_normal(const glm::uvec3& t) const {
    const glm::dvec3 cross = glm::cross(vertices_[t.y] - vertices_[t.x], vertices_[t.z] - vertices_[t.x]);
    return glm::length(cross) > 0.0 ? glm::normalize(cross) : cross;
  }

  static void offer(Nearest& best, const glm::dvec3& p, const glm::dvec3& point, const glm::dvec3& normal) {
    if (const double distance = glm::distance(p, point); distance < best.distance) {
      best = {distance, point, normal};
    }
  }

  void face(const glm::dvec3& p, const glm::uvec3& t, Nearest& best) const {
    const glm::dvec3 normal = face_normal(t);
    if (normal == glm::dvec3(0.0)) {
      return;
    }
    const glm::dvec3 foot = p - glm::dot(p - vertices_[t.x], normal) * normal;
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3& a = vertices_[t[corner]];
      const glm::dvec3& b = vertices_[t[(corner + 1) % 3]];
      if (glm::dot(glm::cross(b - a, foot - a), normal) <= 0.0) {
        return;
      }
    }
    offer(best, p, foot, normal);
  }

  void edge(const glm::dvec3& p, std::uint32_t from, std::uint32_t to, Nearest& best) const {
    const glm::dvec3 along = vertices_[to] - vertices_[from];
    const double t = glm::dot(p - vertices_[from], along) / glm::dot(along, along);
    if (t > 0.0 && t < 1.0) {
      offer(best, p, vertices_[from] + t * along, edge_normals_.at(std::minmax(from, to)));
    }
  }

  void vertex(const glm::dvec3& p, std::uint32_t v, Nearest& best) const {
    offer(best, p, vertices_[v], vertex_normals_[v]);
  }

  std::vector<glm::dvec3> vertices_;
  std::vector<glm::uvec3> triangles_;
  std::vector<glm::dvec3> vertex_normals_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, glm::dvec3> edge_normals_;
};

}  // namespace mayfly::reference
