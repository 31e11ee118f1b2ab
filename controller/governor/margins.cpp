#include "controller/governor/margins.hpp"

#include <cmath>
#include <limits>

namespace mayfly {
namespace {

constexpr double kFloat = 0.5 * std::numeric_limits<float>::epsilon();    // relative, of one rounding
constexpr double kDouble = 0.5 * std::numeric_limits<double>::epsilon();  // relative, of one rounding
constexpr double kRootOfThree = 1.7320508075688773;

}  // namespace

double pose_rounding(double extent) noexcept {
  return 4.0 * kRootOfThree * kFloat * extent;
}

double braking_rounding(const GovernorLimits& limits, double period) noexcept {
  const double speed = limits.speed;
  const double braking = limits.braking;
  const double ticks = std::ceil(speed / (braking * period));
  const double one_tick =
      speed * (period + limits.watchdog + speed / braking) + braking * period * period / 8.0;
  return 2.0 * kFloat * ticks * one_tick;
}

// The longest chain of operations, a vertex of a hull to the gap along a direction, has 40 roundings of
// numbers of at most this size; doubled.
double geometry_rounding(double extent) noexcept {
  return 80.0 * kDouble * extent;
}

double arc_height(const GovernorLimits& limits, double period) noexcept {
  return limits.acceleration * period * period / 8.0;
}

}  // namespace mayfly
