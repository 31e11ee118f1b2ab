// Whether a reservation is free of obstacles, by what is known of the distance to them.
#pragma once

#include <glm/vec3.hpp>

#include "controller/governor/obstacle_view.hpp"
#include "controller/governor/reservation.hpp"

namespace mayfly {

// What a reservation must keep from obstacles, m.
struct Clearance {
  double hard = 0.0;   // what is promised
  double slack = 0.0;  // what is kept besides, so that a robot that rests at a wall can prove its way back
};

// φ ≥ hard + slack all over the capsule. Proven by sphere tracing along its axis: where φ is at least `l`
// above what must be kept, everything within l is clear, because φ changes by no more than one metre a metre.
// May say no where yes is right (a sampled field's error, too many steps along a wall), never the reverse.
bool clear_of_obstacles(const Capsule& capsule, const ObstacleView& obstacles, Clearance clearance) noexcept;

// For a robot that is so near that nothing can be proven with the slack: whether the distance rises by a
// tenth of the way or more to every point that the command adds, and φ falls nowhere below its present value
// less the slack.
bool leaves_obstacle(const Hull& hull, glm::dvec3 position, double spread, const ObstacleView& obstacles,
                     Clearance clearance) noexcept;

}  // namespace mayfly
