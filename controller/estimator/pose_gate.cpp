#include "controller/estimator/pose_gate.hpp"

#include <cmath>

namespace mayfly::estimator {
namespace {

// The corner of the box of 3σ: beyond it lies one in 170000 of normal errors in space.
constexpr double kDeviations = 3.0 * 1.7320508075688772;
// A speed limit is kept in floats.
constexpr double kSpeedRounding = 1e-3;
// Two places are stored as floats (half a unit in the last place each), and their way was added up in floats.
constexpr double kPlaceRounding = 0x1p-21;
constexpr double kLeast = 1e-6;  // m

}  // namespace

double PoseGate::radius(double seconds, double variance, const Place& place) const {
  if (std::isinf(speed)) {
    return speed;
  }
  return (1.0 + kSpeedRounding) * speed * seconds + kDeviations * std::sqrt(variance) + resolution +
         kPlaceRounding * place.cwiseAbs().maxCoeff() + kLeast;
}

bool PoseGate::fits(const Belief& last, double seconds, const Measurement& measured) const {
  const double most = radius(seconds, last.covariance(0, 0) + measured.position_variance, measured.position);
  return (measured.position - last.place()).norm() <= most ||
         (measured.position - last.place_after(seconds)).norm() <= most;
}

bool PoseGate::follows(const Place& first, double seconds, const Measurement& measured) const {
  return (measured.position - first).norm() <=
         radius(seconds, 2.0 * measured.position_variance, measured.position);
}

}  // namespace mayfly::estimator
