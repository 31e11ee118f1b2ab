// What every robot has reserved, and whether two reservations keep their distance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "controller/governor/capsule.hpp"
#include "controller/governor/reservation.hpp"

namespace mayfly {

struct Claim {
  bool present = false;
  Capsule capsule;
  double kept = 0.0;   // m, from the capsule's surface to its half of the distance of two
  double scale = 1.0;  // one over `downwash`
  // Of one that is not ours: a ball that grows, by what it may do in the time that others need to rest.
  double speed = 0.0;         // m/s
  double acceleration = 0.0;  // m/s²
  double age = 0.0;           // s, since it was last seen
};

// m: how far it may get in `time` s from now; 0 of a robot of ours, whose capsule holds all that it may do.
double reach_of(const Claim& claim, double time) noexcept;

enum class Nearness : std::uint8_t {
  kApart,    // everything keeps its distance
  kParting,  // too near to somebody already, and going no nearer than braking would
  kTooNear,
};

// What a robot wants, and what it has.
struct Wish {
  const Claim& claim;
  const Hull& hull;
  const Hull& braking;     // the reservation that braking keeps it in
  glm::dvec3 position;     // m
  double rest_time = 0.0;  // s until it may be at rest
};

// Whether a claim keeps its distance to another: D = kept + kept, in a space that is flattened by the smaller
// scale of the two.
bool keeps_distance(const Claim& claim, const Claim& other, double rest_time) noexcept;

// `others`: of `claims`, whom it may be near to.
Nearness nearness(const Wish& wish, const Claim& present, std::span<const Claim> claims,
                  std::span<const std::uint32_t> others) noexcept;

}  // namespace mayfly
