// What an estimator is told of its robots and of those who measure them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

struct EstimatorLimits {       // one a robot
  float speed = 3.0F;          // m/s, the most it can do; infinite: no jump is told of it
  float acceleration = 20.0F;  // m/s², the most it can do
  float response_time = 0.0F;  // s, by which its velocity lags behind the command
};

// Somebody who measures all robots: a HAL, a motion capture, wheel odometry.
struct EstimatorSource {
  std::string name = "hal";
  // Standard deviations a coordinate, m and m/s. 0 is perfect: the sample is the estimate, bit for bit.
  float pose_noise = 0.0F;
  float velocity_noise = 0.0F;
  bool takes_pose = true;
  // False where velocities are not measured but derived from the poses, which would count them twice.
  bool takes_velocity = true;
  float resolution = 0.0F;  // m, its smallest step; a place that stays within it is no frozen one
};

struct EstimatorConfig {
  Time period{0};          // of the control tick
  Time pose_period{0};     // between two poses of a source that works; 0: the control tick
  Time most_age{0};        // an older pose is kStalePose and not `known`; 0: three pose periods and a tick
  Time most_ahead{0};      // a stamp that lies farther in the future is refused; 0: a control tick
  int frozen_samples = 5;  // this many equal ones with fresh stamps while told to move: kFrozenPose
  // False: no jump, exchange or frozen pose is looked for; what is no number and what is old is still
  // refused. For a swarm that is wholly simulated and not governed: at 10⁵ robots gates take longer than
  // flying.
  bool gates = true;
  std::vector<EstimatorSource> sources{EstimatorSource{}};  // at most kMostSources
  std::vector<EstimatorLimits> robots;

  static constexpr std::size_t kMostSources = 4;
};

// Refuses what is not finite, negative or zero where it may not be, and poses that nobody measures, with the
// numbers. Zero times are replaced by their defaults.
Result<void> check_and_fill(EstimatorConfig& config);

// What became of the samples; one count a sample.
enum class SampleFate : std::uint8_t {
  kTaken,
  kTakenLate,  // older than one that was taken before: put in where it belongs
  kNotFinite,  // or farther away than any place is
  kFuture,
  kTooOld,    // older than all that is remembered, or than the age limit
  kJumped,    // could not have got there
  kFrozen,    // the same bits while it was told to move
  kTooFast,   // a velocity that the robot cannot have; its pose may have been taken
  kUnplaced,  // a velocity of a robot that nobody has seen yet
  kCount
};
inline constexpr std::size_t kSampleFates = static_cast<std::size_t>(SampleFate::kCount);

struct EstimatorCounters {
  std::uint64_t updates = 0;
  std::array<std::uint64_t, kSampleFates> samples{};
  std::uint64_t started_anew = 0;  // robots that were found elsewhere, after three jumps or more
  std::uint64_t id_swaps = 0;      // ticks in which an exchange was seen first

  std::uint64_t of(SampleFate fate) const { return samples[static_cast<std::size_t>(fate)]; }
};

}  // namespace mayfly
