#include "record/plot_solids.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <variant>

#include "fields/mesh.hpp"

namespace mayfly::record {
namespace {

constexpr int kFacets = 48;
constexpr int kRings = kFacets / 2;

using Triangles = std::vector<Triangle>;
using Polygon = std::vector<glm::vec3>;

void add_fan(const Polygon& polygon, Triangles& out) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    out.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
}

std::vector<Polygon> faces_of(const Box& box) {
  std::vector<Polygon> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    for (const float at : {box.min[axis], box.max[axis]}) {
      Polygon face(4);
      for (std::size_t corner = 0; corner < 4; ++corner) {
        face[corner][axis] = at;
        face[corner][a] = corner == 1 || corner == 2 ? box.max[a] : box.min[a];
        face[corner][b] = corner >= 2 ? box.max[b] : box.min[b];
      }
      faces.push_back(face);
    }
  }
  return faces;
}

glm::vec3 on_circle(glm::vec3 u, glm::vec3 v, int facet) {
  const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(facet) / kFacets;
  return std::cos(angle) * u + std::sin(angle) * v;
}

struct Tessellator {
  const Box& bounds;
  Triangles& out;

  Result<void> operator()(const fields::MeshShape& shape) const {
    auto mesh = fields::load_mesh(shape.file).and_then([&](fields::TriangleMesh loaded) {
      return fields::transformed(std::move(loaded), shape);
    });
    if (!mesh) {
      return fail(std::move(mesh.error()));
    }
    for (const glm::uvec3& corner : mesh->triangles) {
      out.push_back({mesh->vertices[corner.x], mesh->vertices[corner.y], mesh->vertices[corner.z]});
    }
    return {};
  }

  Result<void> operator()(const fields::BoxShape& shape) const {
    for (const Polygon& face : faces_of(shape.box)) {
      add_fan(face, out);
    }
    return {};
  }

  Result<void> operator()(const fields::SphereShape& shape) const {
    const auto at = [&](int ring, int facet) {
      const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
      return shape.center + shape.radius * (std::sin(polar) * on_circle({1, 0, 0}, {0, 1, 0}, facet) +
                                            glm::vec3(0, 0, std::cos(polar)));
    };
    for (int ring = 0; ring < kRings; ++ring) {
      for (int facet = 0; facet < kFacets; ++facet) {
        add_fan({at(ring, facet), at(ring + 1, facet), at(ring + 1, facet + 1), at(ring, facet + 1)}, out);
      }
    }
    return {};
  }

  Result<void> operator()(const fields::CylinderShape& shape) const {
    const glm::vec3 axis = glm::normalize(shape.to - shape.from);
    const glm::vec3 other = std::abs(axis.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
    const glm::vec3 u = shape.radius * glm::normalize(glm::cross(axis, other));
    const glm::vec3 v = glm::cross(axis, u);
    for (int facet = 0; facet < kFacets; ++facet) {
      const glm::vec3 a = on_circle(u, v, facet);
      const glm::vec3 b = on_circle(u, v, facet + 1);
      add_fan({shape.from + a, shape.from + b, shape.to + b, shape.to + a}, out);
      out.push_back({shape.from, shape.from + a, shape.from + b});
      out.push_back({shape.to, shape.to + a, shape.to + b});
    }
    return {};
  }

  // The bounds' faces cut by the plane (Sutherland and Hodgman), and the cut itself.
  Result<void> operator()(const fields::HalfSpaceShape& shape) const {
    const auto height = [&](glm::vec3 p) { return glm::dot(shape.normal, p) - shape.offset; };
    Polygon cut;
    for (const Polygon& face : faces_of(bounds)) {
      Polygon kept;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::vec3 p = face[i];
        const glm::vec3 q = face[(i + 1) % face.size()];
        if (height(p) <= 0.0F) {
          kept.push_back(p);
        }
        if ((height(p) <= 0.0F) != (height(q) <= 0.0F)) {
          cut.push_back(p + (q - p) * (height(p) / (height(p) - height(q))));
          kept.push_back(cut.back());
        }
      }
      add_fan(kept, out);
    }
    add_fan(ordered_around_center(std::move(cut), shape.normal), out);
    return {};
  }

  static Polygon ordered_around_center(Polygon points, glm::vec3 normal) {
    if (points.empty()) {
      return points;
    }
    glm::vec3 center(0.0F);
    for (const glm::vec3& p : points) {
      center += p / static_cast<float>(points.size());
    }
    const glm::vec3 n = glm::normalize(normal);
    const glm::vec3 u =
        glm::normalize(glm::cross(n, std::abs(n.z) < 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0)));
    const glm::vec3 v = glm::cross(n, u);
    std::sort(points.begin(), points.end(), [&](const glm::vec3& a, const glm::vec3& b) {
      return std::atan2(glm::dot(a - center, v), glm::dot(a - center, u)) <
             std::atan2(glm::dot(b - center, v), glm::dot(b - center, u));
    });
    return points;
  }
};

}  // namespace

Result<std::vector<Triangle>> triangles_of(std::span<const ObstacleSpec> obstacles, const Box& bounds) {
  Triangles triangles;
  for (const ObstacleSpec& obstacle : obstacles) {
    if (auto done = std::visit(Tessellator{bounds, triangles}, obstacle.shape); !done) {
      return fail(std::move(done.error()));
    }
  }
  return triangles;
}

}  // namespace mayfly::record
