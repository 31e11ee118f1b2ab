// Faults as they happen in the loop: room is taken beforehand, and a fault that goes on is one event.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "controller/flight/summary.hpp"
#include "core/hal.hpp"

namespace mayfly {

class FaultLog {
 public:
  FaultLog() { events_.reserve(kMost); }

  // What one source answered this tick; a fault is logged when it begins or changes.
  class Source {
   public:
    bool begins(const HalResult& result) {
      const bool is_new = result.fault != HalFault::kNone &&
                          (result.fault != fault_ || result.robot != robot_ || result.cause != cause_);
      fault_ = result.fault;
      robot_ = result.robot;
      cause_ = result.cause;
      return is_new;
    }

   private:
    HalFault fault_ = HalFault::kNone;
    RobotIndex robot_ = kEveryRobot;
    std::string_view cause_;  // lives as long as the HAL
  };

  void note(Source& source, Time at, const HalResult& result) noexcept {
    if (!source.begins(result)) {
      return;
    }
    ++count_;
    if (events_.size() < kMost) {
      events_.push_back({at, result.robot, result.link, result.cause});
    }
  }

  std::uint64_t count() const { return count_; }

  std::vector<FaultEvent> told(std::span<const RobotInfo> robots) const {
    std::vector<FaultEvent> told;
    for (const Event& event : events_) {
      const bool one = event.robot < robots.size();
      told.push_back({to_seconds(event.at), one ? robots[event.robot].name : "", std::string(event.link),
                      std::string(event.cause)});
    }
    if (count_ > events_.size()) {
      told.push_back({0.0, "", "", std::to_string(count_ - events_.size()) + " more faults were not kept"});
    }
    return told;
  }

 private:
  static constexpr std::size_t kMost = 1000;
  struct Event {
    Time at;
    RobotIndex robot;
    std::string_view link, cause;
  };
  std::vector<Event> events_;
  std::uint64_t count_ = 0;
};

}  // namespace mayfly
