#include "controller/governor/clearance.hpp"

namespace mayfly {
namespace {

constexpr int kMostTraceSteps = 24;  // bounds the worst tick; a path that needs more runs along a wall
constexpr double kLeastGain = 0.1;   // of the way, so that rounding cannot add up to an approach

bool segment_clear(const ObstacleView& obstacles, glm::dvec3 from, glm::dvec3 to, double wanted) noexcept {
  const glm::dvec3 way = to - from;
  const double length = length3(way);
  double at = 0.0;
  for (int step = 0; step < kMostTraceSteps; ++step) {
    const glm::dvec3 p = from + way * (length > 0.0 ? at / length : 0.0);
    double reach = obstacles.bounds(p).low - wanted;
    if (at + reach < length || !(reach > 0.0)) {
      reach = obstacles.sharpest_bounds(p).low - wanted;
    }
    if (!(reach > 0.0)) {
      return false;
    }
    at += reach;
    if (at >= length) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool clear_of_obstacles(const Capsule& capsule, const ObstacleView& obstacles, Clearance clearance) noexcept {
  const double wanted = clearance.hard + clearance.slack + capsule.radius;
  // Mostly everything is far away: one ball around the middle proves it.
  const glm::dvec3 middle = 0.5 * (capsule.a + capsule.b);
  return obstacles.bounds(middle).low - wanted > 0.5 * length3(capsule.b - capsule.a) ||
         segment_clear(obstacles, capsule.a, capsule.b, wanted);
}

bool leaves_obstacle(const Hull& hull, glm::dvec3 position, double spread, const ObstacleView& obstacles,
                     Clearance clearance) noexcept {
  const ObstacleView::Bounds present = obstacles.sharpest_bounds(position);
  if (present.high >= clearance.hard + 2.0 * clearance.slack + spread) {
    return false;
  }
  for (const glm::dvec3 end : hull.points().last(kCommandPoints - 1)) {
    const double gain = obstacles.sharpest_bounds(end).low - present.high;
    if (!(gain >= kLeastGain * length3(end - position)) ||
        !segment_clear(obstacles, position, end, present.low - clearance.slack)) {
      return false;
    }
  }
  return true;
}

}  // namespace mayfly
