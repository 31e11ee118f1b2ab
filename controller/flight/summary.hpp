// What a flight came to, in the terms of the summary file. SI units. What was not measured is empty, never 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mayfly {

struct LatencySummary {  // µs
  double p50 = 0, p99 = 0, p999 = 0, max = 0;
};

struct Spread {
  double p50 = 0, p99 = 0, max = 0;
};

// One task of the executor.
struct TaskSummary {
  std::string name;
  std::string thread;  // "control", or "own" of a planner
  double rate_hz = 0;
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;                 // releases that no tick served in time
  std::uint64_t missed_by_machine = 0;      // of them, where we slept in time and the machine woke us late
  std::optional<LatencySummary> jitter_us;  // wake-up minus scheduled release; a virtual clock has none
  std::optional<LatencySummary> run_us;     // our own work
};

// A value that crosses from one task to another, as its consumer finds it.
struct AgeSummary {
  std::string name;  // "curl_noise to control"
  double limit_s = 0;
  std::uint64_t expired = 0;    // times it was older than the limit
  std::optional<Spread> age_s;  // at every look; empty where there never was a value
};

struct ControlSummary {
  double rate_hz = 0;
  std::uint64_t ticks = 0;
  std::uint64_t missed = 0;
  std::uint64_t missed_by_machine = 0;
  std::optional<LatencySummary> jitter_us;
  std::optional<LatencySummary> run_us;
  // "virtual" where no right is needed, "granted", or "degraded": flown without the rights below.
  std::string realtime = "virtual";
  std::vector<std::string> missing_rights;
  // How late a bare thread was woken beside the control thread, with its priority and on its processor.
  std::optional<LatencySummary> witness_us;
  std::vector<TaskSummary> tasks;  // control first
  std::vector<AgeSummary> ages;
};

struct FaultEvent {
  double time_s = 0;
  std::string robot;  // empty: all robots of the link
  std::string link;
  std::string cause;
  std::string severity{};  // of the guard's reaction: "hold"; empty where it had none
};

// How often what is promised of the robots did not hold, by their true places and by what they were told.
struct BreachSummary {
  std::uint64_t separation = 0;    // pair-steps of bodies that touch
  std::uint64_t fence = 0;         // robot-steps outside
  std::uint64_t speed = 0;         // commands
  std::uint64_t acceleration = 0;  // commands
  std::uint64_t all() const { return separation + fence + speed + acceleration; }
};

// What the guard did; docs/explanation/guard.md.
struct SafetySummary {
  std::string severity_max = "none";                              // the worst that any robot had at any tick
  std::vector<std::pair<std::string, std::uint64_t>> invariants;  // breaches of each
  std::vector<std::pair<std::string, std::uint64_t>> reactions;   // how many of each severity began
  std::uint64_t wishes_refused = 0;                               // out of sequence
  std::uint64_t stalled_ticks = 0;                                // without a wish that was young enough
  std::uint64_t incidents = 0;                                    // for which a black box was sealed
  std::optional<BreachSummary> breaches;                          // empty where the truth is not known
};

struct ExpectationResult {
  std::string name;             // "reached flies at exit"
  std::optional<double> value;  // empty where it was not measured: then it does not pass
  std::string wanted;           // ">= 0.99"
  bool pass = false;
};

struct PreprocessingSummary {
  double distance = 0, noise = 0, cost = 0;  // s
  bool distance_cached = false, cost_cached = false;
};

// Of fields that are solved again in flight: where goals or obstacles move, or density counts.
struct FieldsSummary {
  std::uint64_t updates = 0;  // sets of fields that were swapped in
  // Control time less the time for which a field's inputs were taken, at every tick; of the oldest field in
  // use.
  std::optional<Spread> age_s;
  std::optional<Spread> solve_s;  // wall time of solving all that is solved again, once an update
  std::uint64_t unreachable = 0;  // times a goal could not be reached any more
};

struct Summary {
  std::string scenario;
  std::string engine;
  std::string hal;
  std::uint64_t seed = 0;
  std::uint64_t agents = 0;
  std::uint64_t ticks = 0;
  double simulated_s = 0;
  double wall_s = 0;
  double realtime_factor = 0;
  std::optional<double> ns_per_agent_tick;
  std::optional<double> reached_fraction;
  std::optional<double> min_separation_m;
  std::optional<std::uint64_t> collisions;
  std::optional<std::uint64_t> penetrations;
  std::optional<double> mde_percent;  // share of agents that MDE moved, mean over frames, in percent
  std::optional<std::uint64_t> infeasible_agents;  // agent-ticks; empty where nobody avoids collisions
  // s: when not one agent had a velocity clear of everybody, first; among the faults as well.
  std::optional<double> all_infeasible_s;
  std::uint64_t governor_interventions = 0;  // agent-ticks
  std::vector<FaultEvent> faults;
  SafetySummary safety;
  std::optional<double> max_speed_mps;
  std::optional<double> max_acceleration_mps2;
  ControlSummary control;
  PreprocessingSummary preprocessing_s;
  std::optional<FieldsSummary> fields;  // empty where nothing is solved in flight
  std::vector<ExpectationResult> expect;
  bool stopped_by_user = false;
};

}  // namespace mayfly
