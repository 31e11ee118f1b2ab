#include "controller/estimator/motion_filter.hpp"

#include <algorithm>

namespace mayfly::estimator {
namespace {

// m/s: what is not known of a robot without a speed limit.
constexpr double kAnySpeed = 1e3;

// Row 0 or 1 of the state is measured. Joseph's form keeps the covariance symmetric and not negative whatever
// the rounding.
void correct_row(Belief& belief, int row, const Eigen::RowVector3d& value, double variance) {
  const double innovation_variance = belief.covariance(row, row) + variance;
  if (innovation_variance > 0.0) {
    const Eigen::Vector2d gain = belief.covariance.col(row) / innovation_variance;
    const Eigen::RowVector3d innovation = value - belief.mean.row(row);
    belief.mean += gain * innovation;
    Eigen::Matrix2d left = Eigen::Matrix2d::Identity();
    left.col(row) -= gain;
    belief.covariance =
        (left * belief.covariance * left.transpose() + variance * gain * gain.transpose()).eval();
  }
  if (variance <= 0.0) {
    belief.mean.row(row) = value;
  }
}

}  // namespace

double acceleration_density(double most_acceleration, double period) {
  return most_acceleration * most_acceleration * period / 3.0;
}

Belief begin(const Measurement& first, double most_speed) {
  const double unknown = std::min(most_speed, kAnySpeed);
  Belief belief;
  belief.mean.row(0) = first.position;
  belief.covariance(0, 0) = first.position_variance;
  belief.covariance(1, 1) = unknown * unknown;
  if (first.has_velocity) {
    belief.mean.row(1) = first.velocity;
    belief.covariance(1, 1) = first.velocity_variance;
  }
  return belief;
}

Belief predict(const Belief& belief, double seconds, double density) {
  const double t = seconds;
  Eigen::Matrix2d step;
  step << 1.0, t, 0.0, 1.0;
  Eigen::Matrix2d disturbance;
  disturbance << t * t * t / 3.0, t * t / 2.0, t * t / 2.0, t;
  Belief later;
  later.mean = step * belief.mean;
  later.covariance = step * belief.covariance * step.transpose() + density * disturbance;
  return later;
}

void correct(Belief& belief, const Measurement& measurement) {
  if (measurement.has_position) {
    correct_row(belief, 0, measurement.position, measurement.position_variance);
  }
  if (measurement.has_velocity) {
    correct_row(belief, 1, measurement.velocity, measurement.velocity_variance);
  }
  // The velocity's correction moves the place that was perfectly known only by rounding.
  if (measurement.has_position && measurement.position_variance <= 0.0) {
    belief.mean.row(0) = measurement.position;
  }
}

}  // namespace mayfly::estimator
