#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "core/finite.hpp"

#include "fields/mesh.hpp"

namespace mayfly::fields {
namespace {

glm::dmat3 rotation_matrix(glm::vec3 degrees) {
  glm::dmat4 rotation(1.0);
  // Extrinsic: about x first, so x stands rightmost.
  rotation = glm::rotate(rotation, glm::radians(static_cast<double>(degrees.z)), glm::dvec3(0, 0, 1));
  rotation = glm::rotate(rotation, glm::radians(static_cast<double>(degrees.y)), glm::dvec3(0, 1, 0));
  rotation = glm::rotate(rotation, glm::radians(static_cast<double>(degrees.x)), glm::dvec3(1, 0, 0));
  return glm::dmat3(rotation);
}

struct Placement {
  glm::dvec3 center{0.0};  // what comes to stand on the position
  double scale = 1.0;
};

Placement fitted(const TriangleMesh& mesh, const glm::dmat3& rotation, double longest) {
  glm::dvec3 low = rotation * glm::dvec3(mesh.vertices[0]);
  glm::dvec3 high = low;
  for (const glm::vec3& v : mesh.vertices) {
    low = glm::min(low, rotation * glm::dvec3(v));
    high = glm::max(high, rotation * glm::dvec3(v));
  }
  const glm::dvec3 side = high - low;
  return {0.5 * (low + high), longest / std::fmax(side.x, std::fmax(side.y, side.z))};
}

}  // namespace

Result<TriangleMesh> transformed(TriangleMesh mesh, const MeshShape& shape) {
  const float size = shape.fit.value_or(shape.scale);
  const std::string what = shape.fit ? "fit" : "scale";
  if (!std::isfinite(size) || size <= 0.0F || !finite(shape.position) || !finite(shape.rotation)) {
    return fail(Error{Cause::kCaller,
                      "mesh '" + shape.file.filename().string() + "' cannot be placed",
                      std::nullopt,
                      what + " " + std::to_string(size),
                      "finite numbers, " + what + " above 0",
                      {}});
  }
  const glm::dmat3 rotation = rotation_matrix(shape.rotation);
  const Placement placement = shape.fit && !mesh.vertices.empty()
                                  ? fitted(mesh, rotation, static_cast<double>(*shape.fit))
                                  : Placement{{}, static_cast<double>(shape.scale)};
  for (glm::vec3& v : mesh.vertices) {
    v = glm::vec3(placement.scale * (rotation * glm::dvec3(v) - placement.center) +
                  glm::dvec3(shape.position));
    if (!finite(v)) {
      return fail(Error{Cause::kCaller,
                        "mesh '" + shape.file.filename().string() + "' is larger than numbers go",
                        std::nullopt,
                        what + " " + std::to_string(size),
                        "a smaller " + what,
                        {}});
    }
  }
  return mesh;
}

}  // namespace mayfly::fields
