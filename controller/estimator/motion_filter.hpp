// The Kalman filter of one robot: constant velocity, disturbed by white acceleration (Bar-Shalom, Li and
// Kirubarajan 2001, §6.2.2).
#pragma once

#include <Eigen/Core>

namespace mayfly::estimator {

using Place = Eigen::RowVector3d;  // m

// The axes are disturbed and measured alike and independently: one covariance serves all three.
struct Belief {
  Eigen::Matrix<double, 2, 3> mean =
      Eigen::Matrix<double, 2, 3>::Zero();               // position over velocity, m and m/s
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of one axis

  Place place() const { return mean.row(0); }
  Place place_after(double seconds) const { return mean.row(0) + seconds * mean.row(1); }
};

struct Measurement {
  Place position = Place::Zero();
  Eigen::RowVector3d velocity = Eigen::RowVector3d::Zero();
  double position_variance = 0.0;  // m²
  double velocity_variance = 0.0;  // m²/s²
  bool has_position = false;
  bool has_velocity = false;
};

// Leaves nothing to be filtered.
inline bool is_perfect(const Measurement& m) {
  return m.has_position && m.has_velocity && m.position_variance <= 0.0 && m.velocity_variance <= 0.0;
}

// Spectral density of the acceleration, m²/s³, of a robot that takes another one at each tick, anything up to
// its limit being as likely: a² T / 3.
double acceleration_density(double most_acceleration, double period);

// From a first measurement of a position. A velocity that was not measured may be anything up to
// `most_speed`.
Belief begin(const Measurement& first, double most_speed);
// `seconds` later, at least 0.
Belief predict(const Belief& belief, double seconds, double density);
// A perfect measurement (variance 0) becomes the mean, bit for bit.
void correct(Belief& belief, const Measurement& measurement);

}  // namespace mayfly::estimator
