// Where each robot is: a constant-velocity Kalman filter a robot, behind gates that let no nonsense in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

struct EstimatorLimits {       // one a robot
  float speed = 3.0F;          // m/s, the most it can do
  float acceleration = 20.0F;  // m/s², the most it can do
};

struct EstimatorConfig {
  Time period{0};           // of the control tick
  Time pose_period{0};      // between two samples of a source that works
  float pose_noise = 0.0F;  // m, standard deviation a coordinate
  Time most_age{0};         // older: kStalePose
  int frozen_samples = 5;   // this many equal ones with fresh stamps while told to move: kFrozenPose
  std::vector<EstimatorLimits> robots;
};

// What is known at a time; one element a robot; m, m/s, world frame, predicted to the tick. `known` is 0
// where nothing may be relied on: never measured, or all that came lately was refused. `stamp` is of the
// newest sample that was taken.
struct EstimateColumns {
  std::span<const float> x, y, z, vx, vy, vz;
  std::span<const Time> stamp;
  std::span<const std::uint8_t> known;
  std::span<const Symptoms> symptoms;  // of each robot
  Symptoms everybody;                  // kIdSwap
};

}  // namespace mayfly
