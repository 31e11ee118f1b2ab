// What swarms do about something that they flee or seek, for whoever asks: measured tick by tick, in double
// precision.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/metrics/last_seen.hpp"
#include "controller/metrics/motion_question.hpp"

namespace mayfly {

// Answers kArrived, kClearing, kParting and kClosing.
class SwarmEncounters {
 public:
  // `ticks`: how many there will be.
  SwarmEncounters(std::vector<MotionQuestion> questions, std::uint64_t ticks);

  void observe(const LastSeen& seen) noexcept;

  // In the order of the questions; empty for others, where nobody was seen, and of parting and closing where
  // there was no encounter.
  std::vector<std::optional<double>> answers() const;

 private:
  struct Asked {
    MotionQuestion question;
    std::optional<double> least{};  // m, to the place, at any tick
    std::optional<double> start{};  // m, the spread when somebody came into reach first
    double largest = 0.0;           // m, the spread from then on
    double sum = 0.0;               // m, of the spread in the flight's last tenth
    std::uint64_t ticks = 0;        // so many of them
    std::optional<double> arrived{};
  };

  void observe_one(Asked& asked, const LastSeen& seen) noexcept;
  void observe_spread(Asked& asked, const LastSeen& seen) noexcept;

  std::vector<Asked> asked_;
  std::uint64_t flight_ticks_;
  std::uint64_t tick_ = 0;
};

}  // namespace mayfly
