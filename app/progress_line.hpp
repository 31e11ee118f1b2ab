// One line of a terminal that says how far something is.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

#include "core/progress.hpp"

namespace mayfly::app {

// On stderr, only if that is a terminal, and only once two seconds have passed: what is quicker needs no
// line. Any thread may call it.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }

  bool wanted() const noexcept { return wanted_; }
  void show(std::string_view text);
  void clear();
  // "cost 45 %"
  Progress stages();

 private:
  bool wanted_;
  std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;
  bool shown_ = false;
};

}  // namespace mayfly::app
