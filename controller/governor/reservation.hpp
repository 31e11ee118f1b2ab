// The space that a robot may need until it rests: docs/explanation/safety.md, pure functions in double
// precision.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "controller/governor/capsule.hpp"
#include "controller/governor/governor_config.hpp"

namespace mayfly {

// What decides how a robot comes to rest.
struct Braking {
  double deceleration = 0.0;  // m/s²
  double period = 0.0;        // s, of the tick
  double watchdog = 0.0;      // s that it may fly on unheard, before it brakes

  double step() const { return deceleration * period; }  // m/s a tick
};

// B(v) = v·(1 − min(1, step/|v|)): the velocity after one tick of braking. m/s.
glm::dvec3 brake(glm::dvec3 velocity, double step) noexcept;

// d(v) = |v|·t_w + |v|²/(2a_b) + a_b·T²/8 (0 if v = 0): how far the robot may still go, m.
double stopping_distance(double speed, const Braking& braking) noexcept;

// The way to where it rests, m; `speed` is not zero.
template <class S>
Vec3<S> stopping_way(const Vec3<S>& velocity, S speed, S deceleration, S period, S watchdog) {
  return velocity *
         (watchdog + speed / (S(2.0) * deceleration) + deceleration * period * period / (S(8.0) * speed));
}

// The same of any velocity.
glm::dvec3 way_to_rest(glm::dvec3 velocity, const Braking& braking) noexcept;

// How many points a command adds to a tail: the position, two ends of the tick and two stops.
inline constexpr std::size_t kCommandPoints = 5;

// The corners of a convex hull, in a fixed place.
class Hull {
 public:
  void add(glm::dvec3 point) noexcept { points_[count_++] = point; }
  Hull shifted(glm::dvec3 way) const noexcept;
  // All of it, moved by `way`, as well: it may be at either place, and between.
  void add_shifted(glm::dvec3 way) noexcept;
  std::span<const glm::dvec3> points() const noexcept { return {points_.data(), count_}; }
  // The least of n · x over it.
  double least_along(glm::dvec3 n) const noexcept;

 private:
  // A body, the leads of the latency, a command's, and a stop without one; as many where it was measured; and
  // two below, of one that lands.
  std::array<glm::dvec3, 2 * (1 + kMostLatency + kCommandPoints + 1) + 2> points_{};
  std::size_t count_ = 0;
};

// Adds to a tail what is needed from `position` on, at `velocity` before and `command` from now on: the ends
// of the tick, and from each the way to rest. The tick ends after T·(v + w)/2 if the velocity changes
// linearly, after T·w if at once, in between if sooner than linearly: both are reserved, so that the proof
// holds for all of them.
void add_command(Hull& hull, glm::dvec3 position, glm::dvec3 velocity, glm::dvec3 command,
                 const Braking& braking) noexcept;

}  // namespace mayfly
