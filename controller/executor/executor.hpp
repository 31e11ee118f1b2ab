// Runs tasks at fixed rates, and measures how punctual they were.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "controller/executor/planner_loop.hpp"
#include "controller/executor/releases.hpp"
#include "controller/executor/task_stats.hpp"
#include "controller/executor/witness.hpp"
#include "core/clock.hpp"
#include "core/result.hpp"

namespace mayfly {

// Two kinds of tasks, both released at start + k·period:
//
// - Tasks of the control thread, the one that calls run(). Of those that are due the one with the earliest
//   deadline (its next release) goes first, then the order in which they were added. Each is an ArmedTick.
// - Planners, whose work may be longer than control can wait: in threads of their own, handing results over
//   through a Handover.
//
// On a virtual clock all of them run in the one thread, in an order that is the same on any machine: at one
// moment first results that are ready by then, in the order of adding; then tasks of the control thread, as
// above; then planners' work, in the order of adding. A planner works at its release and its result is there
// `latency` later, on either clock; on the real clock later still, where the work takes longer. A control
// task that senses before it acts lets all of that moment in between its halves, so that with a latency of 0
// it acts on what was planned from what it has just sensed.
class Executor {
 public:
  explicit Executor(Clock& clock) : clock_(clock), witness_(working_) {}

  // How the control thread runs, on the real clock.
  struct Realtime {
    int priority = 0;      // SCHED_FIFO that it was granted, for the witness to have the same
    int cpu = -1;          // the processor that it keeps to during run(); -1: any
    bool witness = false;  // whether to measure how late a bare thread is woken beside it
  };
  void set_realtime(const Realtime& realtime) { realtime_ = realtime; }

  // `rate_hz` in [0.001, 100 000]. `function` is called as void(const TickInfo&) and must be noexcept. Fails
  // for another rate or a name that is taken.
  template <class Function>
  Result<void> add_task(const std::string& name, double rate_hz, Function function) {
    static_assert(kIsTask<Function>, "a task is called as void(const TickInfo&) noexcept");
    return add_control(name, rate_hz, nullptr, std::move(function));
  }
  // In two halves.
  template <class Sense, class Act>
  Result<void> add_task(const std::string& name, double rate_hz, Sense sense, Act act) {
    static_assert(kIsTask<Sense> && kIsTask<Act>, "a task is called as void(const TickInfo&) noexcept");
    return add_control(name, rate_hz, std::move(sense), std::move(act));
  }
  // `latency` in [0, period]: what passes between a release and publish().
  template <class Work, class Publish>
  Result<void> add_planner(const std::string& name, double rate_hz, Time latency, Work work,
                           Publish publish) {
    static_assert(kIsTask<Work> && kIsTask<Publish>, "a planner is called as void(const TickInfo&) noexcept");
    return add(name, rate_hz, latency, std::move(work), std::move(publish));
  }

  // Runs every release in [0, duration), then waits for the end of `duration`. Ends early, before the next
  // task, once `stop` is true: a signal handler may set it. Between the first release and the end it
  // allocates nothing, throws nothing. May be called again: release 0 is then the time of that call, and the
  // statistics go on. Fails, before anything ran, where a thread cannot be had. Waits for planners that are
  // at work.
  Result<void> run(Time duration, const std::atomic<bool>& stop) noexcept;

  // One element a task: those of the control thread in the order they were added, then planners. Not while
  // run() is running.
  std::vector<TaskStats> stats() const;
  const Witness& witness() const { return witness_; }

 private:
  using Function = std::function<void(const TickInfo&)>;
  template <class F>
  static constexpr bool kIsTask = std::is_nothrow_invocable_v<F&, const TickInfo&>;

  struct ControlTask {
    Releases releases;
    Function sense;  // may be empty
    Function act;
  };

  bool is_taken(const std::string& name) const;
  Result<void> add_control(const std::string& name, double rate_hz, Function sense, Function act);
  Result<void> add(const std::string& name, double rate_hz, Time latency, Function work, Function publish);
  Result<void> start_beside(Time start, Time duration);
  void end_beside() noexcept;
  void run_control(Time start, Time duration, const std::atomic<bool>& stop) noexcept;
  ControlTask* earliest_due(Time now, Time duration) noexcept;
  Time next_event(Time duration) const noexcept;
  void run_task(ControlTask& task, Time start, Time now, Time duration) noexcept;
  bool publish_pending(Time now) noexcept;
  bool run_planners(Time start, Time now, Time duration) noexcept;

  Clock& clock_;
  Realtime realtime_;
  std::vector<ControlTask> tasks_;
  std::deque<PlannerTask> planners_;  // stay where they are: threads hold on to them
  std::vector<std::thread> threads_;
  std::atomic<bool> ending_{false};
  WorkMark working_;
  Witness witness_;
  Sleep sleep_;
};

}  // namespace mayfly
