#include "controller/governor/reservation.hpp"

namespace mayfly {
namespace {

constexpr int kMostTraceSteps = 24;  // bounds the worst tick; a path that needs more runs along a wall
constexpr double kLeastGain = 0.1;   // of the way, so that rounding cannot add up to an approach

bool in_box(glm::dvec3 p, glm::dvec3 low, glm::dvec3 high) noexcept {
  return p.x >= low.x && p.y >= low.y && p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
}

bool segment_clear(const ObstacleView& obstacles, glm::dvec3 from, glm::dvec3 way, double wanted) noexcept {
  const double length = glm::length(way);
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

bool path_clear(const Reservation& r, const ObstacleView& obstacles, double wanted) noexcept {
  return segment_clear(obstacles, r.from, r.end_linear - r.from, wanted) &&
         segment_clear(obstacles, r.end_linear, r.stop, wanted);
}

bool moves_away(const Reservation& r, const ObstacleView& obstacles, double present) noexcept {
  for (const glm::dvec3 end : {r.end_linear, r.end_at_once, r.end_linear + r.stop, r.end_at_once + r.stop}) {
    const double gain = obstacles.sharpest_bounds(end).low - present;
    if (!(gain >= kLeastGain * glm::length(end - r.from))) {
      return false;
    }
  }
  return true;
}

}  // namespace

glm::dvec3 brake(glm::dvec3 velocity, double step) noexcept {
  const double speed = glm::length(velocity);
  return speed > step ? velocity * (1.0 - step / speed) : glm::dvec3(0.0);
}

double stopping_distance(double speed, double braking, double period) noexcept {
  return speed > 0.0 ? speed * speed / (2.0 * braking) + braking * period * period / 8.0 : 0.0;
}

Reservation reserve(glm::dvec3 position, glm::dvec3 velocity, glm::dvec3 command, double braking,
                    double period) noexcept {
  const double speed = glm::length(command);
  Reservation r;
  r.from = position;
  r.end_linear = position + 0.5 * period * (velocity + command);
  r.end_at_once = position + period * command;
  r.stop = speed > 0.0 ? command * (stopping_distance(speed, braking, period) / speed) : glm::dvec3(0.0);
  // Half of T·|w − v| between the two ends, and an eighth between the parabola and its chord.
  r.sag = 0.625 * period * glm::length(command - velocity);
  return r;
}

bool inside_fence(const Reservation& r, glm::dvec3 low, glm::dvec3 high) noexcept {
  const glm::dvec3 least{r.from.x < low.x ? r.from.x : low.x, r.from.y < low.y ? r.from.y : low.y,
                         r.from.z < low.z ? r.from.z : low.z};
  const glm::dvec3 most{r.from.x > high.x ? r.from.x : high.x, r.from.y > high.y ? r.from.y : high.y,
                        r.from.z > high.z ? r.from.z : high.z};
  return in_box(r.end_linear, least, most) && in_box(r.end_at_once, least, most) &&
         in_box(r.end_linear + r.stop, least, most) && in_box(r.end_at_once + r.stop, least, most);
}

bool clear_of_obstacles(const Reservation& r, const ObstacleView& obstacles, Clearance clearance) noexcept {
  const double wanted = clearance.hard + clearance.slack + r.sag;
  // Mostly everything is far away: one ball around the end of the tick proves the rest.
  const double stop = glm::length(r.stop);
  const double tick = glm::length(r.end_linear - r.from);
  if (obstacles.bounds(r.end_linear).low - wanted > (stop > tick ? stop : tick)) {
    return true;
  }
  if (path_clear(r, obstacles, wanted)) {
    return true;
  }
  const ObstacleView::Bounds present = obstacles.sharpest_bounds(r.from);
  return present.high < wanted + clearance.slack && moves_away(r, obstacles, present.high) &&
         path_clear(r, obstacles, present.low - clearance.slack);
}

}  // namespace mayfly
