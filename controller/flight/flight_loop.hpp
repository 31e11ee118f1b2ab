// One flight's state, and what a control tick does with it. For flight.cpp only.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/flight/estimate.hpp"
#include "controller/flight/fault_log.hpp"
#include "controller/flight/field_keeper.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/roster.hpp"
#include "controller/flight/stimuli.hpp"
#include "controller/governor/governor.hpp"
#include "controller/metrics/metrics.hpp"

namespace mayfly {

// Columns are taken at the start; a tick allocates nothing.
class FlightLoop {
 public:
  // `motion` is what governor and metrics see obstacles and goals by; it is kept at the time of the tick.
  // `keeper` may be null: then fields stay as they are.
  FlightLoop(const FlightParts& parts, Motion& motion, FieldKeeper* keeper, Governor governor,
             Metrics metrics);

  void tick() noexcept;

  const std::atomic<bool>& finished() const { return finished_; }
  Summary summarise(ControlSummary timing, double wall_s) const;

 private:
  struct Columns3 {
    explicit Columns3(std::size_t n) : x(n), y(n), z(n) {}
    VelocityColumns writable() { return {x, y, z}; }
    std::vector<float> x, y, z;
  };

  int stop_level() const { return parts_.stop == nullptr ? 0 : parts_.stop->load(std::memory_order_relaxed); }
  // The true state where a simulation knows it, else the estimate: what metrics and observers see.
  const Estimate& seen() const { return parts_.truth != nullptr ? truth_ : estimate_; }
  double seconds_flown(Time now) const { return to_seconds(now - began_); }

  void note(FaultLog::Source& source, Time now, const HalResult& result) noexcept;
  void note_liar(Time now, std::optional<RobotIndex> liar) noexcept;
  void observe_truth() noexcept;
  void leave_out_absent(Columns3& places) const noexcept;
  void count_infeasible(Time now, std::size_t infeasible) noexcept;
  void renew_fields(Time now) noexcept;
  void look_ahead() noexcept;
  void judge_ages(Time now) noexcept;
  void decide(Time now) noexcept;
  void write(Time now) noexcept;
  void show(Time now) noexcept;
  void end_if_asked(Time now) noexcept;

  const FlightParts& parts_;
  Motion& motion_;
  FieldKeeper* keeper_;
  std::size_t agents_;
  Time period_;
  Governor governor_;
  Metrics metrics_;
  Estimate estimate_;
  Estimate truth_;
  Roster roster_;
  MovingStimuli stimuli_;
  std::vector<float> lead_;           // s, one an agent
  std::vector<std::uint8_t> avoids_;  // one an agent: whether it avoids collisions; empty: nobody does
  Columns3 there_;                    // m; of the swarm as it is known, without those who are not there
  Columns3 ahead_;
  Columns3 desired_;
  Columns3 command_;
  std::vector<std::uint8_t> known_;  // one an agent: whether its state is young enough to fly by
  std::vector<Authority> authority_;
  std::vector<CommandKind> kind_;
  FaultLog faults_;
  FaultLog::Source hal_source_, state_source_, write_source_, engine_source_, solver_source_,
      avoidance_source_;
  std::vector<FaultLog::Source> goal_sources_;  // one a swarm
  std::uint64_t sequence_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint64_t moved_ = 0;                 // agent-ticks in which MDE moved somebody
  std::uint64_t infeasible_ = 0;            // agent-ticks in which no velocity was clear of everybody
  std::uint64_t avoiding_ = 0;              // agent-ticks of those who avoid collisions
  std::optional<double> all_infeasible_s_;  // when nobody had such a velocity first
  Time began_{0};
  Time flown_{0};
  // Read once a tick: a request that comes in its middle must not end the flight before it was written.
  int asked_to_stop_ = 0;
  Time stop_began_ = Time::min();
  std::chrono::steady_clock::duration work_{0};
  std::atomic<bool> finished_{false};
};

}  // namespace mayfly
