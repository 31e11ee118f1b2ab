#include "fields/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "fields/double8.hpp"
#include "fields/geometry_parts.hpp"
#include "fields/hash.hpp"
#include "fields/mesh.hpp"

namespace mayfly::fields {
namespace {

bool holds(const Box& box, const glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (point[axis] < static_cast<double>(box.min[axis]) ||
        point[axis] > static_cast<double>(box.max[axis])) {
      return false;
    }
  }
  return true;
}

bool inside(const TriangleTree& solid, const glm::dvec3& point) noexcept {
  return holds(solid.bounds(), point) && solid.winding(point) != 0;
}

// The distance, if it is less than `limit`; else `limit`.
double nearest_below(const TriangleTree& tree, const glm::dvec3& point, double limit) noexcept {
  if (!(limit > 0.0)) {
    return limit;
  }
  const double limit_squared = limit * limit;
  double squared = limit_squared;
  std::uint32_t hint = TriangleTree::kNoHint;
  tree.nearest<double>({point.x, point.y, point.z}, squared, hint);
  return squared < limit_squared ? std::sqrt(squared) : limit;
}

double shell_distance(const Shell& shell, const glm::dvec3& point, double limit) noexcept {
  const double reach = limit + shell.half_thickness;
  const double distance = nearest_below(shell.tree, point, reach);
  return distance < reach ? distance - shell.half_thickness : limit;
}

void add_to(ContentHash& hash, std::string_view kind, const TriangleMesh& mesh, double half_thickness) {
  hash.add(kind).add(half_thickness);
  hash.add_all(std::span<const glm::vec3>(mesh.vertices));
  hash.add_all(std::span<const glm::uvec3>(mesh.triangles));
}

void add_to(ContentHash& hash, glm::vec3 a) {
  hash.add(a.x).add(a.y).add(a.z);
}

void add_to(ContentHash& hash, const BoxShape& shape) {
  hash.add("box");
  add_to(hash, shape.box.min);
  add_to(hash, shape.box.max);
}
void add_to(ContentHash& hash, const SphereShape& shape) {
  hash.add("sphere").add(shape.radius);
  add_to(hash, shape.center);
}
void add_to(ContentHash& hash, const CylinderShape& shape) {
  hash.add("cylinder").add(shape.radius);
  add_to(hash, shape.from);
  add_to(hash, shape.to);
}
void add_to(ContentHash& hash, const HalfSpaceShape& shape) {
  hash.add("half-space").add(shape.offset);
  add_to(hash, shape.normal);
}

Result<TriangleMesh> world_mesh(const MeshShape& shape) {
  auto placed =
      load_mesh(shape.file).and_then([&](TriangleMesh mesh) { return transformed(std::move(mesh), shape); });
  if (!placed || shape.thin) {
    return placed;
  }
  return make_solid(std::move(*placed), shape.file.filename().string());
}

// Adds shape after shape; the first that is wrong ends it.
struct Assembler {
  Geometry::Parts& parts;
  ContentHash& hash;
  float default_thickness;

  Result<void> operator()(const MeshShape& shape) {
    const float thickness = shape.thickness.value_or(default_thickness);
    if (shape.thin && !(std::isfinite(thickness) && thickness > 0.0F)) {
      return fail(Error{Cause::kCaller,
                        "a thin mesh needs a thickness",
                        std::nullopt,
                        std::to_string(thickness) + " m",
                        "a finite number above 0",
                        {}});
    }
    Result<TriangleMesh> mesh = world_mesh(shape);
    if (!mesh) {
      return tl::unexpected(std::move(mesh.error()));
    }
    parts.triangles += mesh->triangles.size();
    const double half_thickness = shape.thin ? 0.5 * static_cast<double>(thickness) : 0.0;
    add_to(hash, shape.thin ? "shell" : "solid", *mesh, half_thickness);
    if (shape.thin) {
      parts.shells.push_back({TriangleTree(*mesh), half_thickness});
    } else {
      parts.solids.emplace_back(*mesh);
    }
    return {};
  }

  template <class Formula>
  Result<void> operator()(const Formula& shape) {
    add_to(hash, shape);
    parts.primitives.emplace_back(shape);
    return check(parts.primitives.back());
  }
};

}  // namespace

double Geometry::Parts::solid_distance(const glm::dvec3& point) const noexcept {
  double distance = static_cast<double>(kNoObstacle);
  for (const TriangleTree& solid : solids) {
    // Inside, the distance to this mesh's own surface counts, however near another's may be.
    const bool within = inside(solid, point);
    const double own = nearest_below(solid, point, within ? static_cast<double>(kNoObstacle) : distance);
    distance = std::min(distance, within ? -own : own);
  }
  return distance;
}

double Geometry::Parts::signed_distance(const glm::dvec3& point) const noexcept {
  double distance = solid_distance(point);
  for (const Shell& shell : shells) {
    distance = shell_distance(shell, point, distance);
  }
  for (const Primitive& primitive : primitives) {
    distance = std::min(distance, fields::signed_distance(primitive, point));
  }
  return distance;
}

std::optional<Box> Geometry::Parts::bounds() const noexcept {
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  Box all{glm::vec3(kEndless), glm::vec3(-kEndless)};
  const auto add = [&](const Box& box, float around) {
    all.min = glm::min(all.min, box.min - around);
    all.max = glm::max(all.max, box.max + around);
  };
  for (const TriangleTree& solid : solids) {
    add(solid.bounds(), 0.0F);
  }
  for (const Shell& shell : shells) {
    add(shell.tree.bounds(), static_cast<float>(shell.half_thickness));
  }
  for (const Primitive& primitive : primitives) {
    const std::optional<Box> box = bounds_of(primitive);
    if (!box) {
      return std::nullopt;
    }
    add(*box, 0.0F);
  }
  return all;
}

Result<Geometry> Geometry::make(std::span<const PlacedShape> shapes, float default_thickness) try {
  auto parts = std::make_unique<Parts>();
  ContentHash hash;
  for (const PlacedShape& placed : shapes) {
    Result<void> added = std::visit(Assembler{*parts, hash, default_thickness}, placed.shape);
    if (!added) {
      added.error().place = placed.place;
      return tl::unexpected(std::move(added.error()));
    }
  }
  parts->content_hash = hash.hex();
  return Geometry(std::move(parts));
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for the world's meshes");
}

Geometry::Geometry(std::unique_ptr<const Parts> parts) noexcept : parts_(std::move(parts)) {}
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;
Geometry::~Geometry() = default;

float Geometry::signed_distance(glm::vec3 point) const noexcept {
  return static_cast<float>(parts_->signed_distance(glm::dvec3(point)));
}

bool Geometry::contains(glm::vec3 point) const noexcept {
  const glm::dvec3 p(point);
  const auto in_solid = [&](const TriangleTree& solid) { return inside(solid, p); };
  const auto in_shell = [&](const Shell& shell) {
    return nearest_below(shell.tree, p, shell.half_thickness) < shell.half_thickness;
  };
  const auto in_primitive = [&](const Primitive& primitive) {
    return fields::signed_distance(primitive, p) <= 0.0;
  };
  return std::ranges::any_of(parts_->solids, in_solid) || std::ranges::any_of(parts_->shells, in_shell) ||
         std::ranges::any_of(parts_->primitives, in_primitive);
}

bool Geometry::empty() const noexcept {
  return parts_->solids.empty() && parts_->shells.empty() && parts_->primitives.empty();
}

std::optional<Box> Geometry::bounds() const noexcept {
  return parts_->bounds();
}

std::size_t Geometry::triangle_count() const noexcept {
  return parts_->triangles;
}

const std::string& Geometry::content_hash() const noexcept {
  return parts_->content_hash;
}

}  // namespace mayfly::fields
