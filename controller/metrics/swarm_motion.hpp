// How swarms move as a whole, for whoever asks: measured tick by tick, in double precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "controller/metrics/last_seen.hpp"
#include "controller/metrics/motion_question.hpp"

namespace mayfly {

// Answers kCentreDrift, kDistance, kTurns and kSpread. Turns are unwrapped: from one tick to the next an
// agent goes the nearer way round, so that a tick must be shorter than half a turn; right on the axis it has
// no angle, and keeps the one before.
class SwarmMotion {
 public:
  // `ticks`: how many the flight will have. One that ends before its last half or tenth has no answer there.
  // Allocates all that is ever needed.
  SwarmMotion(std::vector<MotionQuestion> questions, std::uint64_t ticks);

  void observe(const LastSeen& seen) noexcept;

  // In the order of the questions; empty where nothing was measured.
  std::vector<std::optional<double>> answers() const;

 private:
  struct Asked {
    MotionQuestion question;
    std::vector<glm::dvec2> heading;  // kTurns: from the axis to each agent when it last had an angle
    std::vector<double> angle;        // kTurns: rad, unwrapped
    std::vector<std::uint8_t> met;    // kTurns: whether it was ever seen
    std::optional<glm::dvec3> start;  // kCentreDrift
    double sum = 0.0;                 // of the ticks that count; kCentreDrift: the largest
    std::uint64_t ticks = 0;
  };

  void observe_one(Asked& asked, const LastSeen& seen) noexcept;
  static void turn(Asked& asked, const LastSeen& seen) noexcept;
  static std::optional<double> turns(const Asked& asked);

  std::vector<Asked> asked_;
  std::uint64_t flight_ticks_;
  std::uint64_t tick_ = 0;
};

}  // namespace mayfly
