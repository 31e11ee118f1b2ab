// Reservations as capsules, and how far two of them are apart.
//
// Both questions are answered by a witness: a share t of a segment, a direction n. However badly a witness
// was found, what follows from it is true, and only rounding can spoil it: by how much, a test finds by
// running the same formulas on intervals. Hence the templates.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>

namespace mayfly {

template <class S>
using Vec3 = glm::vec<3, S>;

inline double square(double x) {
  return x * x;
}

template <class S>
S dot3(const Vec3<S>& a, const Vec3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class S>
S length3(const Vec3<S>& v) {
  using std::sqrt;
  return sqrt(square(v.x) + square(v.y) + square(v.z));
}

// The distance from x to the point at share t of a → b: for any t in [0, 1] at least that to the segment.
template <class S>
S distance_at(const Vec3<S>& x, const Vec3<S>& a, const Vec3<S>& b, double t) {
  return length3(Vec3<S>(x - (a + (b - a) * S(t))));
}

// By how much p lies beyond q along n, times |n|: for any n at most |n| times the distance of the two
// segments.
template <class S>
S gap_along(const Vec3<S>& n, const Vec3<S>& p0, const Vec3<S>& p1, const Vec3<S>& q0, const Vec3<S>& q1) {
  using std::max;
  using std::min;
  return min(dot3(n, p0), dot3(n, p1)) - max(dot3(n, q0), dot3(n, q1));
}

// All points within `radius` of the segment a → b; m.
struct Capsule {
  glm::dvec3 a{0.0}, b{0.0};
  double radius = 0.0;
};

// Contains every one of the points, hence their convex hull. At least one.
Capsule capsule_around(std::span<const glm::dvec3> points) noexcept;

// The nearest to `place` of all that it contains.
glm::dvec3 nearest_in(const Capsule& capsule, glm::dvec3 place) noexcept;

// From q's axis to p's, where they are nearest: any length, zero where they meet.
glm::dvec3 nearest_way(const Capsule& p, const Capsule& q) noexcept;

// Whether the axes are at least `distance` apart: false where it cannot be shown.
bool apart(const Capsule& p, const Capsule& q, double distance) noexcept;

// The same in a space that is less high: heights times `scale`, at most 1, which makes nothing longer.
Capsule flattened(const Capsule& capsule, double scale) noexcept;

}  // namespace mayfly
