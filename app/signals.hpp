// Ctrl-C stops the swarm first, then the program.
#pragma once

#include "controller/flight/flight.hpp"

namespace mayfly::app {

// From construction to destruction SIGINT and SIGTERM raise stop(): the first asks the swarm to hold, the
// second is the emergency stop. The third ends the program at once, unless it is the guard: that outlives
// every request to stop, for somebody has to bring the robots down, and a closed terminal, too. One at a
// time.
class StopSignals {
 public:
  enum class Of { kPlanner, kGuard };
  explicit StopSignals(Of of = Of::kPlanner);
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  const StopRequest& stop() const noexcept;
  // The signal that came last; 0 where none did.
  int signal_number() const noexcept;
};

}  // namespace mayfly::app
