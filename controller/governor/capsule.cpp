#include "controller/governor/capsule.hpp"

namespace mayfly {
namespace {

// Where on a → b it is nearest to x.
double share_nearest(glm::dvec3 x, glm::dvec3 a, glm::dvec3 b) noexcept {
  const glm::dvec3 way = b - a;
  const double squared = dot3(way, way);
  return squared > 0.0 ? std::clamp(dot3(x - a, way) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace

Capsule capsule_around(std::span<const glm::dvec3> points) noexcept {
  Capsule capsule{points.front(), points.front(), 0.0};
  double farthest = 0.0;
  for (const glm::dvec3& point : points) {
    const glm::dvec3 way = point - capsule.a;
    if (const double squared = dot3(way, way); squared > farthest) {
      farthest = squared;
      capsule.b = point;
    }
  }
  for (const glm::dvec3& point : points) {
    const double t = share_nearest(point, capsule.a, capsule.b);
    capsule.radius = std::max(capsule.radius, distance_at(point, capsule.a, capsule.b, t));
  }
  return capsule;
}

glm::dvec3 nearest_in(const Capsule& capsule, glm::dvec3 place) noexcept {
  const double t = share_nearest(place, capsule.a, capsule.b);
  const glm::dvec3 on_axis = capsule.a + t * (capsule.b - capsule.a);
  const double away = length3(place - on_axis);
  return away > capsule.radius ? on_axis + (capsule.radius / away) * (place - on_axis) : place;
}

// The nearest points of two segments by alternating between them: of the middle line first, then each end's
// best answer (Ericson, Real-Time Collision Detection, 5.1.9).
glm::dvec3 nearest_way(const Capsule& p, const Capsule& q) noexcept {
  const glm::dvec3 u = p.b - p.a;
  const glm::dvec3 v = q.b - q.a;
  const glm::dvec3 between = p.a - q.a;
  const double uu = dot3(u, u);
  const double uv = dot3(u, v);
  const double vv = dot3(v, v);
  const double across = uu * vv - uv * uv;
  const double share =
      across > 0.0 ? std::clamp((uv * dot3(v, between) - vv * dot3(u, between)) / across, 0.0, 1.0) : 0.0;
  const glm::dvec3 on_q = q.a + v * share_nearest(p.a + u * share, q.a, q.b);
  return p.a + u * share_nearest(on_q, p.a, p.b) - on_q;
}

bool apart(const Capsule& p, const Capsule& q, double distance) noexcept {
  const glm::dvec3 n = nearest_way(p, q);
  return gap_along(n, p.a, p.b, q.a, q.b) >= length3(n) * distance && dot3(n, n) > 0.0;
}

Capsule flattened(const Capsule& capsule, double scale) noexcept {
  Capsule flat = capsule;
  flat.a.z *= scale;
  flat.b.z *= scale;
  return flat;
}

}  // namespace mayfly
