// How orderly a swarm is, for whoever asks: measured tick by tick, in double precision.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/metrics/last_seen.hpp"
#include "controller/metrics/motion_question.hpp"
#include "controller/metrics/nearest_distance.hpp"

namespace mayfly {

// |mean v̂|: 1 where all fly the same way. Who stands still counts as one without a direction.
std::optional<double> polarisation(const LastSeen& seen, AgentRange range) noexcept;

// |mean of (r × v)_z / |r||v||, r and v seen from above, r from the centre: 1 where all circle it the same
// way round.
std::optional<double> milling(const LastSeen& seen, AgentRange range) noexcept;

// Answers kPolarisation, kMilling and kNearest: means of the flight's second half; of kNearest, which costs
// more, of a hundred moments of it.
class SwarmOrder {
 public:
  // `ticks`: how many there will be.
  SwarmOrder(const std::vector<MotionQuestion>& questions, std::uint64_t ticks);

  void observe(const LastSeen& seen) noexcept;

  // In the order of the questions; empty for others, and where nobody was seen.
  std::vector<std::optional<double>> answers() const;

 private:
  struct Asked {
    MotionQuestion::Kind kind = MotionQuestion::Kind::kNone;
    AgentRange range;
    double sum = 0.0;
    std::uint64_t ticks = 0;
  };
  std::vector<Asked> asked_;
  NearestDistance nearest_;
  std::uint64_t flight_ticks_;
  std::uint64_t stride_;  // ticks between two moments of kNearest
  std::uint64_t tick_ = 0;
};

}  // namespace mayfly
