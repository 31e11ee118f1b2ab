// Signed distances of the shapes that are formulas.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <variant>

#include "core/result.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

using Primitive = std::variant<BoxShape, SphereShape, CylinderShape, HalfSpaceShape>;

// m, negative inside; exact everywhere, inside too.
// Why it cannot throw: primitives.cpp. NOLINTNEXTLINE(bugprone-exception-escape)
double signed_distance(const Primitive& primitive, const glm::dvec3& point) noexcept;

// Nothing for a half-space, which has no end.
std::optional<Box> bounds_of(const Primitive& primitive) noexcept;

// Refuses numbers that are not finite, empty boxes, radii that are not positive, cylinders and normals
// without a length.
Result<void> check(const Primitive& primitive);

}  // namespace mayfly::fields
