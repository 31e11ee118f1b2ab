// Boxes that lie along the surface they hold. For triangle_tree.cpp only.
//
// A surface patch that is askew to the axes leaves most of an axis-aligned box empty, and a point at distance
// d must look into every box within about √(2 · d · thickness) of its nearest one: many, where the patch is
// small and far. A box along the patch is nearly flat.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "fields/double8.hpp"
#include "kernels/lane.h"

namespace mayfly::fields {

struct alignas(64) OrientedBox {
  glm::vec3 center{0.0F};  // relative to the tree's middle, where floats are exact enough
  std::array<glm::vec3, 3> axes{};
  glm::vec3 half{0.0F};    // along the axes; a little more than needed, for all that floats round away
  std::uint32_t link = 0;  // for the tree
};

// The smaller of two boxes around the corners, three a triangle: along the mean normal, and axis-aligned.
// `slack` (m) is added on every side.
OrientedBox box_around(std::span<const glm::vec3> corners, float slack);

// What a query's points are to boxes: T = double gives float, Double8 gives eight floats.
template <class T>
struct Narrow;
template <>
struct Narrow<double> {
  using Type = float;
};
template <>
struct Narrow<Double8> {
  using Type = kernels::F;
};

inline float narrow(double a) {
  return static_cast<float>(a);
}
inline kernels::F narrow(Double8 a) {
  using Float4 = float __attribute__((vector_size(16)));
  return __builtin_shufflevector(__builtin_convertvector(a.low, Float4),
                                 __builtin_convertvector(a.high, Float4), 0, 1, 2, 3, 4, 5, 6, 7);
}

inline float beyond(float u, float half) {
  const float over = (u < 0.0F ? -u : u) - half;
  return over > 0.0F ? over : 0.0F;
}
inline kernels::F beyond(kernels::F u, float half) {
  return kernels::mf_max(kernels::mf_max(u, -u) - half, kernels::mf_splat(0.0F));
}
inline bool any_below(float a, float b) {
  return a < b;
}
inline bool any_below(kernels::F a, kernels::F b) {
  return kernels::mf_any(a < b) != 0;
}
inline float first_lane(float a) {
  return a;
}
inline float first_lane(kernels::F a) {
  return a[0];
}

// Never more than the squared distance from the point to anything in the box.
template <class L>
L least_distance_squared(const OrientedBox& box, const std::array<L, 3>& point) {
  constexpr float kRounding = 1.0F - 4e-6F;
  const L x = point[0] - box.center.x;
  const L y = point[1] - box.center.y;
  const L z = point[2] - box.center.z;
  const auto along = [&](std::size_t axis) {
    const glm::vec3& a = box.axes[axis];
    return beyond(x * a.x + y * a.y + z * a.z, box.half[static_cast<int>(axis)]);
  };
  const L u = along(0);
  const L v = along(1);
  const L w = along(2);
  return (u * u + v * v + w * w) * kRounding;
}

}  // namespace mayfly::fields
