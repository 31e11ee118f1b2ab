#include "controller/governor/reservation.hpp"

#include <limits>

namespace mayfly {

glm::dvec3 brake(glm::dvec3 velocity, double step) noexcept {
  const double speed = length3(velocity);
  return speed > step ? velocity * (1.0 - step / speed) : glm::dvec3(0.0);
}

double stopping_distance(double speed, const Braking& braking) noexcept {
  return speed > 0.0 ? speed * braking.watchdog + speed * speed / (2.0 * braking.deceleration) +
                           braking.step() * braking.period / 8.0
                     : 0.0;
}

glm::dvec3 way_to_rest(glm::dvec3 velocity, const Braking& braking) noexcept {
  const double speed = length3(velocity);
  return speed > 0.0 ? stopping_way(velocity, speed, braking.deceleration, braking.period, braking.watchdog)
                     : glm::dvec3(0.0);
}

Hull Hull::shifted(glm::dvec3 way) const noexcept {
  Hull hull;
  for (const glm::dvec3& point : points()) {
    hull.add(point + way);
  }
  return hull;
}

void Hull::add_shifted(glm::dvec3 way) noexcept {
  const std::size_t before = count_;
  for (std::size_t n = 0; n < before; ++n) {
    add(points_[n] + way);
  }
}

double Hull::least_along(glm::dvec3 n) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : points()) {
    least = std::min(least, dot3(n, point));
  }
  return least;
}

void add_command(Hull& hull, glm::dvec3 position, glm::dvec3 velocity, glm::dvec3 command,
                 const Braking& braking) noexcept {
  const glm::dvec3 stop = way_to_rest(command, braking);
  const glm::dvec3 linear = position + 0.5 * braking.period * (velocity + command);
  const glm::dvec3 at_once = position + braking.period * command;
  hull.add(position);
  hull.add(linear);
  hull.add(at_once);
  hull.add(linear + stop);
  hull.add(at_once + stop);
}

}  // namespace mayfly
