// How a guard brings a flight to its end when there is nobody left to lead it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "core/clock.hpp"

namespace mayfly::link {

// From flying to braking as soon as the end is wanted. Where the planner wants it, that is all once everybody
// rests: its HAL's own way of letting go follows. Where the planner has died they hold a while, then land,
// and are let go when nobody is in the air. None of it may take for ever: each stage has a longest time,
// after which the next begins. From high up a landing takes as long as it takes: its longest time begins anew
// while somebody still sinks, but not for ever.
class FlightEnd {
 public:
  enum class Stage : std::uint8_t { kFlying, kBraking, kLanding, kDone };

  static constexpr Time kMostBraking = std::chrono::seconds(5);
  static constexpr Time kHolding = std::chrono::seconds(1);          // counted from the start of braking
  static constexpr Time kMostLanding = std::chrono::seconds(20);     // with nobody sinking
  static constexpr Time kMostAltogether = std::chrono::minutes(10);  // of landing

  struct Seen {
    bool end_wanted = false;
    bool planner_died = false;
    bool all_still = false;  // nobody is told to move, and nobody does
    bool airborne = false;   // anybody
    bool sinking = false;    // anybody who lands
  };

  // Once a tick. At most one stage a tick, so that each is told to the robots at least once.
  Stage update(Time now, const Seen& seen) noexcept {
    const Time in_stage = now - since_;
    switch (stage_) {
      case Stage::kFlying:
        enter_if(seen.end_wanted || seen.planner_died, Stage::kBraking, now);
        break;
      case Stage::kBraking:
        died_ = died_ || seen.planner_died;
        enter_if((seen.all_still && (!died_ || in_stage >= kHolding)) || in_stage > kMostBraking,
                 died_ ? Stage::kLanding : Stage::kDone, now);
        break;
      case Stage::kLanding:
        sank_ = seen.sinking ? now : std::max(sank_, since_);
        enter_if(!seen.airborne || now - sank_ > kMostLanding || in_stage > kMostAltogether, Stage::kDone,
                 now);
        break;
      case Stage::kDone:
        break;
    }
    return stage_;
  }
  Stage stage() const noexcept { return stage_; }

 private:
  void enter_if(bool condition, Stage next, Time now) noexcept {
    if (condition) {
      stage_ = next;
      since_ = now;
    }
  }

  Stage stage_ = Stage::kFlying;
  bool died_ = false;
  Time since_{0};
  Time sank_{0};  // when somebody was seen to sink last
};

}  // namespace mayfly::link
