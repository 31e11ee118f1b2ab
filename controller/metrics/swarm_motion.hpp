// How swarms move as a whole, for whoever asks: measured tick by tick, in double precision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace mayfly {

struct MotionQuestion {
  enum class Kind {
    kNone,         // not about motion: its answer stays empty
    kCentreDrift,  // m, the farthest that the centre was from where it was first seen
    kDistance,     // m, mean distance to `place`, over agents and the flight's second half
    kTurns,        // mean over agents of |turns| about the vertical axis through `place`
    kSpread        // m, radius of gyration, √(mean |r − centre|²), mean of the flight's last tenth
  };
  Kind kind = Kind::kNone;
  std::size_t first = 0;  // of the swarm's agents
  std::size_t count = 0;
  // m, where it is now: kDistance, kTurns. Must not throw, and allocates nothing.
  std::function<glm::dvec3()> place{};
};

// An agent whose place is not known at a tick counts where it was last; one that was never seen, not at all.
// Turns are unwrapped: from one tick to the next an agent goes the nearer way round, so that a tick must be
// shorter than half a turn; right on the axis it has no angle, and keeps the one before.
class SwarmMotion {
 public:
  // `ticks`: how many the flight will have. One that ends before its last half or tenth has no answer there.
  // Allocates all that is ever needed.
  SwarmMotion(std::vector<MotionQuestion> questions, std::size_t agents, std::uint64_t ticks);

  // m, one element an agent; shorter columns leave the rest unseen.
  void observe(std::span<const float> x, std::span<const float> y, std::span<const float> z) noexcept;

  // In the order of the questions; empty where nothing was measured.
  std::vector<std::optional<double>> answers() const;

 private:
  struct Asked {
    MotionQuestion question;
    std::vector<glm::dvec2> heading;  // kTurns: from the axis to each agent when it last had an angle
    std::vector<double> angle;        // kTurns: rad, unwrapped
    std::optional<glm::dvec3> start;  // kCentreDrift
    double sum = 0.0;                 // of the ticks that count; kCentreDrift: the largest
    std::uint64_t ticks = 0;
  };

  void remember(std::span<const float> x, std::span<const float> y, std::span<const float> z) noexcept;
  void observe_one(Asked& asked) noexcept;
  void turn(Asked& asked) noexcept;
  std::optional<glm::dvec3> centre(const MotionQuestion& question) const noexcept;
  std::optional<double> mean_square(const MotionQuestion& question, glm::dvec3 from) const noexcept;
  std::optional<double> mean_distance(const MotionQuestion& question, glm::dvec3 from) const noexcept;
  std::optional<double> turns(const Asked& asked) const;

  std::vector<Asked> asked_;
  std::vector<glm::vec3> place_;     // m, where each agent was last
  std::vector<std::uint8_t> known_;  // whether it was anywhere
  std::uint64_t flight_ticks_;
  std::uint64_t tick_ = 0;
};

}  // namespace mayfly
