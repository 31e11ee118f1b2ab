// One flight's state, and what a control tick does with it. For flight.cpp only.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/flight/estimate.hpp"
#include "controller/flight/fault_log.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/roster.hpp"
#include "controller/guard/guard_port.hpp"
#include "controller/metrics/metrics.hpp"
#include "controller/planner/curl_noise_planner.hpp"

namespace mayfly {

// Columns are taken at the start; a tick allocates nothing.
class FlightLoop {
 public:
  // `guard` stands before the robots: what is decided here is a wish to it. `motion` is what guard and
  // metrics see obstacles and goals by; it is kept at the time of the tick. `beside` is the planner that runs
  // `planner` in a task of its own; null: it runs in the tick.
  FlightLoop(const FlightParts& parts, Motion& motion, FieldPlanner& planner, CurlNoisePlanner* beside,
             GuardPort& guard, Metrics metrics);

  // The two halves of a tick: what there is, and what is to be done.
  void sense() noexcept;
  void act() noexcept;

  const std::atomic<bool>& finished() const { return finished_; }
  Summary summarise(ControlSummary timing, double wall_s) const;

 private:
  int stop_level() const { return parts_.stop == nullptr ? 0 : parts_.stop->load(std::memory_order_relaxed); }
  // The true state where a simulation knows it, else the estimate: what metrics and observers see.
  const Estimate& seen() const { return parts_.truth != nullptr ? truth_ : estimate_; }
  double seconds_flown(Time now) const { return to_seconds(now - began_); }

  void note(FaultLog::Source& source, Time now, const HalResult& result) noexcept;
  void observe_truth() noexcept;
  SwarmView view() const noexcept;
  const Plan* newest_plan(Time now) noexcept;
  void note_found(Time now, const Plan& plan) noexcept;
  void wish(Time now, const Plan* plan) noexcept;
  void decide(Time now) noexcept;
  void write(Time now) noexcept;
  void show(Time now) noexcept;
  void end_if_asked(Time now) noexcept;

  const FlightParts& parts_;
  Motion& motion_;
  FieldPlanner& planner_;
  CurlNoisePlanner* beside_;
  std::size_t agents_;
  Time period_;
  GuardPort& guard_;
  Metrics metrics_;
  Estimate estimate_;
  Estimate truth_;
  Roster roster_;
  Plan plan_;  // where it is made in the tick
  Columns3 desired_;
  std::vector<CommandKind> kind_;  // of the wish
  bool has_planned_ = false;
  Time wish_until_{0};
  FaultLog faults_;
  FaultLog::Source hal_source_, write_source_, engine_source_, solver_source_, avoidance_source_,
      planner_source_;
  std::vector<FaultLog::Source> goal_sources_;  // one a swarm
  std::uint64_t sequence_ = 0;
  std::uint64_t ticks_ = 0;
  std::optional<double> all_infeasible_s_;  // when nobody had such a velocity first
  Time now_{0};                             // of this tick
  Time began_{0};
  Time flown_{0};
  // Read once a tick: a request that comes in its middle must not end the flight before it was written.
  int asked_to_stop_ = 0;
  Time stop_began_ = Time::min();
  std::chrono::steady_clock::duration work_{0};
  std::atomic<bool> finished_{false};
};

}  // namespace mayfly
