// What the guard said of the robots, beside what became of them: whether a breach is one of what was
// promised.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/guard/guarded_hal.hpp"
#include "core/clock.hpp"
#include "simulate/breach_watch.hpp"

namespace mayfly::bench {

// Stands before a watch, which knows nothing of the guard. In lock step.
class GuardWitness final : public sim_hal::StepWatcher {
 public:
  // `tube`: m. Room is taken for `ticks`. Passes all on to `next`, in which `breaches` are counted; both
  // outlive it, and so does whoever is heard.
  GuardWitness(sim_hal::StepWatcher& next, const simulate::BreachWatch& breaches, std::size_t robots,
               std::size_t ticks, float tube);
  void hear(GuardedHal& guard) noexcept { guard_ = &guard; }

  void on_step(const sim_hal::PoseView& truth) noexcept override;
  void on_command(Time now, const CommandColumns& commands) noexcept override;

  // Of the watch's breaches those in which a robot had a part whose guarantee was suspended, and told so by
  // the tick before or by `late` after it: it did not go where it was told, or nobody knew where it was. A
  // contact that began so stays so until it ends.
  simulate::BreachCounts suspended(Time late) const;

  // Times from the first command on. When the robot was first off its reference by more than the tube, from
  // `at` on; empty: never.
  std::optional<double> left_tube(std::size_t robot, double at) const;
  // s between the two in which it was told to move.
  double told_to_move(std::size_t robot, double from, double until) const;

 private:
  struct Seen {  // of one robot, at a command
    bool suspended = false;
    bool off = false;
    bool moves = false;
  };
  Seen look(std::size_t robot, const CommandColumns& commands) const noexcept;
  const Seen& seen(std::size_t tick, std::size_t robot) const { return seen_[tick * robots_ + robot]; }
  bool is_suspended(std::size_t robot, Time at, Time late) const;

  sim_hal::StepWatcher& next_;
  const simulate::BreachWatch& breaches_;
  std::size_t robots_;
  double tube_;
  GuardedHal* guard_ = nullptr;
  std::vector<glm::dvec3> truth_;  // m, one a robot
  std::vector<Time> times_;
  std::vector<Seen> seen_;  // at each of them, one a robot
};

}  // namespace mayfly::bench
