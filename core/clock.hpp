// Time is injected: everything that runs in flight asks a Clock, never the operating system.
#pragma once

#include <chrono>

namespace mayfly {

// Nanoseconds since the clock's own start; monotonic. Wall-clock time exists only in labels.
using Time = std::chrono::nanoseconds;

inline double to_seconds(Time time) {
  return std::chrono::duration<double>(time).count();
}
inline Time from_seconds(double seconds) {
  return std::chrono::duration_cast<Time>(std::chrono::duration<double>(seconds));
}

class Clock {
 public:
  virtual ~Clock() = default;
  virtual Time now() const noexcept = 0;
  // Returns at `deadline` or later; at once if it has passed. A virtual clock jumps to it.
  virtual void sleep_until(Time deadline) noexcept = 0;
  // True where time only passes in sleep_until, so that a run is reproducible bit for bit.
  virtual bool is_virtual() const noexcept = 0;
};

}  // namespace mayfly
