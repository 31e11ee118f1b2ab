// Keeps a flight's fields up to date, off the control loop.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/executor/latency_histogram.hpp"
#include "controller/flight/field_set.hpp"
#include "controller/flight/field_solver.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/hal.hpp"

namespace mayfly {

// At a planner's tick the control loop takes over the set of fields that was asked for at the one before, and
// asks for the next. A thread of its own solves it in between. There are two sets: the one that is flown by,
// and the one that is being written; whose turn it is stands in one atomic number, so that the control loop
// neither locks nor waits nor allocates, and on the real clock calls the system for nothing.
//
// On a virtual clock control waits at a planner's tick for a set that is not ready: time stands still, and
// the set that is flown by at a tick does not depend on how fast anybody is. On the real clock it flies on by
// the old set; the planner's tick is then the first control tick that finds the new one.
class FieldKeeper {
 public:
  struct Settings {
    bool waits = true;  // on a virtual clock
    int threads = 1;    // of a solve
  };

  // Starts the thread. All must outlive it. Errors: no memory, no thread.
  static Result<std::unique_ptr<FieldKeeper>> start(const Scenario& scenario, FieldSolver& solver,
                                                    Settings settings);
  FieldKeeper(const FieldKeeper&) = delete;
  FieldKeeper& operator=(const FieldKeeper&) = delete;
  ~FieldKeeper();

  // Once a control tick, before the engine computes. `motion` is at that time.
  void tick(double time_s, const PositionColumns& at, const Motion& motion, Engine& engine) noexcept;

  // What is wrong with the fields of a swarm: its goal is out of reach for some of its agents. Texts live as
  // long as the keeper.
  HalResult state_of(std::size_t swarm) const noexcept;
  // That no set could be solved lately.
  HalResult solver_state() const noexcept;
  // A goal went out of reach: told by whoever logs state_of().
  void count_unreachable() noexcept { ++unreachable_; }

  FieldsSummary summary() const;

 private:
  enum class Turn : int { kControl, kSolver, kReady, kEnd };

  FieldKeeper(const Scenario& scenario, FieldSolver& solver, Settings settings);
  void work() noexcept;
  void await_other(Turn turn) noexcept;
  void take_over(Engine& engine) noexcept;
  void ask(double time_s, const PositionColumns& at) noexcept;

  const Scenario& scenario_;
  FieldSolver& solver_;
  Settings settings_;
  double period_s_;
  double step_s_;         // s between the last two planner's ticks: the period, or longer where solving is
  double next_s_ = 0.0;   // planner's tick
  double asked_s_ = 0.0;  // planner's tick before
  bool is_asked_ = false;
  FieldInputs inputs_;
  FieldSet sets_[2];
  int flown_ = 0;  // of the two sets; the solver writes the other
  double flown_time_s_ = 0.0;
  bool failed_ = false;  // the last set could not be solved
  std::atomic<bool> solved_{true};
  std::vector<std::size_t> goal_of_;           // one a swarm; how many goals there are, where it is not led
  std::vector<std::string> unreachable_text_;  // one a swarm
  LatencyHistogram ages_, solves_;
  std::uint64_t updates_ = 0;
  std::uint64_t unreachable_ = 0;
  std::atomic<Turn> turn_{Turn::kControl};
  std::thread thread_;
};

}  // namespace mayfly
