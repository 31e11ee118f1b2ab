#include "controller/governor/claims.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// Two capsules in one ball each: mostly that is enough.
bool balls_apart(const Capsule& p, const Capsule& q, double distance) noexcept {
  const glm::dvec3 between = 0.5 * ((p.a + p.b) - (q.a + q.b));
  const double reach = distance + 0.5 * (length3(p.b - p.a) + length3(q.b - q.a));
  return dot3(between, between) > reach * reach;
}

// Whether nothing of what is wanted lies nearer to `other` than what braking keeps, seen along the shortest
// way between the two, or where they meet, along that between their beginnings.
bool goes_no_nearer(const Wish& wish, const Claim& present, const Claim& other) noexcept {
  const double scale = std::min(present.scale, other.scale);
  const Capsule mine = flattened(present.capsule, scale);
  const Capsule theirs = flattened(other.capsule, scale);
  glm::dvec3 n = nearest_way(mine, theirs);
  if (!(dot3(n, n) > 0.0)) {
    n = wish.position - other.capsule.a;
    n.z *= scale;
  }
  n.z *= scale;
  return dot3(n, n) > 0.0 && wish.hull.least_along(n) >= wish.braking.least_along(n);
}

// Whoever is between two places where a robot may be, or in the column below one that lands, leaves what is
// reserved sideways: along it, it would come to the robot itself.
bool keeps_off_ends(const Wish& wish, const Claim& present, const Claim& other) noexcept {
  for (const glm::dvec3 end : {other.capsule.a, other.capsule.b}) {
    Claim place = other;
    place.capsule.a = place.capsule.b = end;
    if (!keeps_distance(wish.claim, place, wish.rest_time) && !goes_no_nearer(wish, present, place)) {
      return false;
    }
  }
  return true;
}

}  // namespace

double reach_of(const Claim& claim, double time) noexcept {
  const double free = time + claim.age;
  return claim.acceleration > 0.0 ? claim.speed * free + 0.5 * claim.acceleration * free * free : 0.0;
}

bool keeps_distance(const Claim& claim, const Claim& other, double rest_time) noexcept {
  const double distance =
      claim.kept + other.kept + claim.capsule.radius + other.capsule.radius + reach_of(other, rest_time);
  const double scale = std::min(claim.scale, other.scale);
  const Capsule p = flattened(claim.capsule, scale);
  const Capsule q = flattened(other.capsule, scale);
  return balls_apart(p, q, distance) || apart(p, q, distance);
}

Nearness nearness(const Wish& wish, const Claim& present, std::span<const Claim> claims,
                  std::span<const std::uint32_t> others) noexcept {
  Nearness all = Nearness::kApart;
  for (const std::uint32_t j : others) {
    const Claim& other = claims[j];
    if (!other.present || keeps_distance(wish.claim, other, wish.rest_time)) {
      continue;
    }
    if (keeps_distance(present, other, wish.rest_time) || !goes_no_nearer(wish, present, other) ||
        !keeps_off_ends(wish, present, other)) {
      return Nearness::kTooNear;
    }
    all = Nearness::kParting;
  }
  return all;
}

}  // namespace mayfly
