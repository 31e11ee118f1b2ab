#include "fields/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <string>

#include "core/finite.hpp"

namespace mayfly::fields {
namespace {

// Signed distance to a box about the origin; serves the cylinder too, whose radius and half height make a
// rectangle.
template <class Vec>
double centered_box_distance(const Vec& point, const Vec& half) {
  const Vec over = glm::abs(point) - half;
  double deepest = over[0];
  for (int axis = 1; axis < Vec::length(); ++axis) {
    deepest = std::max(deepest, over[axis]);
  }
  return glm::length(glm::max(over, Vec(0.0))) + std::min(deepest, 0.0);
}

struct Distance {
  glm::dvec3 point;

  double operator()(const BoxShape& shape) const {
    const glm::dvec3 low(shape.box.min);
    const glm::dvec3 high(shape.box.max);
    return centered_box_distance(point - 0.5 * (low + high), 0.5 * (high - low));
  }
  double operator()(const SphereShape& shape) const {
    return glm::length(point - glm::dvec3(shape.center)) - static_cast<double>(shape.radius);
  }
  double operator()(const CylinderShape& shape) const {
    const glm::dvec3 axis = glm::dvec3(shape.to) - glm::dvec3(shape.from);
    const double height = glm::length(axis);
    const glm::dvec3 from_middle = point - 0.5 * (glm::dvec3(shape.from) + glm::dvec3(shape.to));
    const double along = glm::dot(from_middle, axis) / height;
    const double across = glm::length(from_middle - along / height * axis);
    // From the axis outwards only, so the rectangle's side at −radius is never met.
    return centered_box_distance(glm::dvec2(across, along), glm::dvec2(shape.radius, 0.5 * height));
  }
  double operator()(const HalfSpaceShape& shape) const {
    const glm::dvec3 normal(shape.normal);
    return (glm::dot(normal, point) - static_cast<double>(shape.offset)) / glm::length(normal);
  }
};

tl::unexpected<Error> refuse(std::string what, std::string wanted) {
  return fail(Error{Cause::kCaller, std::move(what), std::nullopt, {}, std::move(wanted), {}});
}

struct Check {
  Result<void> operator()(const BoxShape& shape) const {
    const Box& box = shape.box;
    if (!finite(box.min) || !finite(box.max) || box.min.x >= box.max.x || box.min.y >= box.max.y ||
        box.min.z >= box.max.z) {
      return refuse("the box is empty or infinite", "finite numbers, min below max along each axis");
    }
    return {};
  }
  Result<void> operator()(const SphereShape& shape) const {
    if (!finite(shape.center) || !std::isfinite(shape.radius) || shape.radius <= 0.0F) {
      return refuse("the sphere has no extent", "a finite center and a radius above 0");
    }
    return {};
  }
  Result<void> operator()(const CylinderShape& shape) const {
    if (!finite(shape.from) || !finite(shape.to) || shape.from == shape.to || !std::isfinite(shape.radius) ||
        shape.radius <= 0.0F) {
      return refuse("the cylinder has no extent", "finite ends that differ and a radius above 0");
    }
    return {};
  }
  Result<void> operator()(const HalfSpaceShape& shape) const {
    if (!finite(shape.normal) || !std::isfinite(shape.offset) || shape.normal == glm::vec3(0.0F)) {
      return refuse("the half-space has no direction", "a finite offset and a normal that is not zero");
    }
    return {};
  }
};

}  // namespace

// A shape moves without throwing, so a Primitive always holds one. NOLINTNEXTLINE(bugprone-exception-escape)
double signed_distance(const Primitive& primitive, const glm::dvec3& point) noexcept {
  return std::visit(Distance{point}, primitive);
}

std::optional<Box> bounds_of(const Primitive& primitive) noexcept {
  if (const auto* box = std::get_if<BoxShape>(&primitive)) {
    return box->box;
  }
  if (const auto* sphere = std::get_if<SphereShape>(&primitive)) {
    return Box{sphere->center - sphere->radius, sphere->center + sphere->radius};
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&primitive)) {
    return Box{glm::min(cylinder->from, cylinder->to) - cylinder->radius,
               glm::max(cylinder->from, cylinder->to) + cylinder->radius};
  }
  return std::nullopt;
}

Result<void> check(const Primitive& primitive) {
  return std::visit(Check{}, primitive);
}

}  // namespace mayfly::fields
