// Where each robot is: a constant-velocity Kalman filter a robot, behind gates that let no nonsense in
// (docs/explanation/estimation.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "controller/estimator/estimator_config.hpp"
#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

// What is known at a time; one element a robot; m, m/s, world frame, predicted to the tick. `known` is 0
// where nothing may be relied on: never measured, or no pose was taken for longer than the age limit; the
// numbers are then the last that were, or NaN where there were none. `stamp` is of the newest pose that was
// taken. `fresh` is 1 where this update took one.
struct EstimateColumns {
  std::span<const float> x, y, z, vx, vy, vz;
  std::span<const Time> stamp;
  std::span<const std::uint8_t> known;
  std::span<const Symptoms> symptoms;  // of each robot
  Symptoms everybody;                  // kIdSwap
  std::span<const std::uint8_t> fresh{};
  // 1 where this update began the track elsewhere, because of jumps that agree: the robot was carried off, or
  // whoever measures it errs.
  std::span<const std::uint8_t> anew{};
  // m/s, over and above what it was told, averaged over the last tenths of a second; 0 without gates.
  std::span<const float> drift_x{}, drift_y{}, drift_z{};
};

// How sure the filter is of a robot: standard deviations a coordinate, m and m/s, and their covariance.
struct Uncertainty {
  double position = 0.0;
  double velocity = 0.0;
  double covariance = 0.0;  // m²/s
};

// One tick: let every source fill its inbox, then update(), then, when the commands are written, sent().
// Nothing but create() allocates. One thread.
class Estimator {
 public:
  static Result<Estimator> create(EstimatorConfig config);
  Estimator(Estimator&&) noexcept;
  Estimator& operator=(Estimator&&) noexcept;
  ~Estimator();

  std::size_t robots() const noexcept;
  // Where a source writes this tick's samples: hand it to Hal::read. What it does not touch stays from
  // before; a stamp that was there at the last update is no new sample.
  StateColumns inbox(std::size_t source = 0) noexcept;
  // Takes the samples in the order of their stamps, predicts everybody to `now`, and tells what is wrong.
  void update(Time now) noexcept;
  // What the robots were told at `now`, as sent. Commands say who should be moving (kFrozenPose); they do not
  // enter the estimate, which must not believe that a robot obeys.
  void sent(Time now, const CommandColumns& commands) noexcept;

  // As of the last update; the columns stay where they are, whatever is moved or updated.
  EstimateColumns estimate() const noexcept;
  // As the sources left it; those without telemetry leave it at its defaults.
  std::span<const Telemetry> telemetry(std::size_t source = 0) const noexcept;
  // Of a robot's filter, as of its newest sample.
  Uncertainty uncertainty(std::size_t robot) const noexcept;
  const EstimatorCounters& counters() const noexcept;
  const EstimatorConfig& config() const noexcept;

 private:
  class Work;
  explicit Estimator(std::unique_ptr<Work> work);
  std::unique_ptr<Work> work_;
};

}  // namespace mayfly
