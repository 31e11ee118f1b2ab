// The rights that a flight on the real clock, or its guard, asks of the operating system.
#pragma once

#include "controller/clock/realtime_rights.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"

namespace mayfly {

// Above ordinary work, below what the kernel itself needs (threaded interrupts run at 50, migration at 99).
inline constexpr int kControlPriority = 80;

// Held by the calling thread until destruction.
class FlightRights {
 public:
  // Fails (environment) where one is refused and the scenario enforces them: names each, with its remedy.
  static Result<FlightRights> take(RealtimePolicy policy);
  FlightRights(FlightRights&& other) noexcept;
  FlightRights& operator=(FlightRights&&) = delete;
  ~FlightRights();

  const RealtimeRights& granted() const { return rights_; }
  // "SCHED_FIFO priority 80 (Operation not permitted): add …", one a right that was refused.
  std::vector<std::string> missing() const;

 private:
  explicit FlightRights(RealtimeRights rights);

  RealtimeRights rights_;
  bool held_ = true;
};

}  // namespace mayfly
