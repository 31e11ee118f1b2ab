// Whether a robot can have got where a sample says that it is.
#pragma once

#include "controller/estimator/estimator_config.hpp"
#include "controller/estimator/motion_filter.hpp"

namespace mayfly::estimator {

// No place is farther from the origin, m, a coordinate; a sample beyond it is not a place.
inline constexpr double kFarthest = 1e6;
// m/s, a coordinate; no velocity is larger.
inline constexpr double kFastest = 1e4;

struct PoseGate {
  double speed = 0.0;       // m/s, may be infinite
  double resolution = 0.0;  // m

  // m: how far from the last place, and from the one expected, a sample may be: v_max·Δt, and 3σ in every
  // coordinate, and what rounding does to a column of floats.
  double radius(double seconds, double variance, const Place& place) const;
  // Whether `measured` may come `seconds` after `last`. A robot that reverses is far from where it was
  // expected, one that is faster than its limit far from where it was: only who is far from both has jumped.
  bool fits(const Belief& last, double seconds, const Measurement& measured) const;
  // The same between two samples of which the first was not taken.
  bool follows(const Place& first, double seconds, const Measurement& measured) const;
};

}  // namespace mayfly::estimator
