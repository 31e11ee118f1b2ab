// The space that a robot may need until it rests, and whether it is free (safety.md §1.2). The governor's
// geometry, as pure functions in double precision.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "controller/governor/obstacle_view.hpp"
#include "core/grid.hpp"

namespace mayfly {

// B(v) = v·(1 − min(1, a_b·T/|v|)): the velocity after one tick of braking. step = a_b·T, m/s.
glm::dvec3 brake(glm::dvec3 velocity, double step) noexcept;

// d(v) = |v|²/(2a_b) + a_b·T²/8 (0 if v = 0): how far the robot may still go, m.
double stopping_distance(double speed, double braking, double period) noexcept;

// What a command w reserves from p, at velocity v before: the way to where the tick ends, then the stopping
// segment.
//
// Where the tick ends depends on the plant: after p + T·(v + w)/2 if the velocity changes linearly over the
// tick, after p + T·w if at once, in between if sooner than linearly. Both are reserved, so that the proof
// holds for all of them.
struct Reservation {
  glm::dvec3 from{0.0};        // p
  glm::dvec3 end_linear{0.0};  // of the tick
  glm::dvec3 end_at_once{0.0};
  glm::dvec3 stop{0.0};  // from either end to where the robot rests, m
  double sag = 0.0;  // m, the most by which any of these paths leaves the chord from → end_linear → + stop
};

Reservation reserve(glm::dvec3 position, glm::dvec3 velocity, glm::dvec3 command, double braking,
                    double period) noexcept;

// A convex fence contains a reservation if it contains its corners. A robot that is outside already may move
// as long as it comes no further out: the box is stretched to hold its present place.
bool inside_fence(const Reservation& reservation, glm::dvec3 low, glm::dvec3 high) noexcept;

// What a reservation must keep from obstacles, m.
struct Clearance {
  double hard = 0.0;   // radius + tube: what is promised
  double slack = 0.0;  // what is kept besides, so that a robot that rests at a wall can prove its way back
};

// φ ≥ hard along the whole reservation, whichever way the tick ends. Proven by sphere tracing: where φ is at
// least `l` above what must be kept, everything within l is clear, because φ changes by no more than one
// metre a metre.
//
// A robot that is so near that nothing can be proven with the slack may still move if the distance rises by a
// tenth of the way or more at every end of the reservation, and φ falls nowhere below its present value less
// the slack. May say no where yes is right (a sampled field's error, too many steps along a wall), never the
// reverse.
bool clear_of_obstacles(const Reservation& reservation, const ObstacleView& obstacles,
                        Clearance clearance) noexcept;

}  // namespace mayfly
