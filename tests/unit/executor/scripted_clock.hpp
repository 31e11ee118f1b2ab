// Time that passes when the test says so.
#pragma once

#include <algorithm>

#include "core/clock.hpp"

namespace mayfly {

// Work takes as long as a task adds, and a sleep ends `oversleep` late.
class ScriptedClock final : public Clock {
 public:
  Time now() const noexcept override { return now_; }
  void sleep_until(Time deadline) noexcept override {
    now_ = std::max(now_, deadline) + oversleep;
    oversleep = Time{0};
  }
  bool is_virtual() const noexcept override { return true; }
  void work(Time duration) noexcept { now_ += duration; }

  Time oversleep{0};  // of the next sleep only

 private:
  Time now_ = std::chrono::seconds(5);  // a run need not begin with the clock
};

}  // namespace mayfly
