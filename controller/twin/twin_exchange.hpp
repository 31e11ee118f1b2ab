// Robots that are taken out of a run at a set time, and put back later: with a guard, on both sides of it.
#pragma once

#include <vector>

#include "controller/guard/exchange.hpp"
#include "controller/twin/twin_hal.hpp"

namespace mayfly {

// Times since the first tick; `back` at Time::max() is never.
struct TwinSpell {
  RobotIndex robot = 0;
  Time out{0};
  Time back = Time::max();
};

// From `out` on a robot's twin flies in its place, and the robot holds where it is; all others keep clear of
// it. From `back` on the guard leads the twin to the robot, through the governor; there the robot is put
// back, and goes on as the planner wishes. What is refused (a robot without a pose, one that has drifted
// away) is tried again.
class TwinExchange final : public Exchange {
 public:
  // `hal` is what the guard flies, and outlives it. `braking`: m/s², one a robot, at which a robot that is
  // taken out comes to rest; `response_time`: s, for which it goes on before that.
  TwinExchange(TwinHal& hal, std::vector<TwinSpell> spells, std::vector<float> braking,
               std::vector<float> response_time);

  void tick(Time now, Guard& guard) noexcept override;
  std::span<const KeptClear> kept_clear() noexcept override;

 private:
  enum class Stage { kIn, kAskedOut, kOut, kLed, kAskedBack, kDone };

  Stage next(const TwinSpell& spell, Stage stage, Time flown, Guard& guard) noexcept;

  TwinHal& hal_;
  std::vector<TwinSpell> spells_;
  std::vector<Stage> stages_;
  std::vector<float> braking_, response_time_;
  std::vector<KeptClear> kept_clear_;  // with room for all
  Time began_ = Time::min();
};

}  // namespace mayfly
