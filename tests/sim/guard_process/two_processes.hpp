// A flight in two processes, from outside: started, watched through its shared memory, and ill-treated.
#pragma once

#include <sys/types.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "controller/link/segment.hpp"
#include "tests/sim/program/process.hpp"
#include "tests/sim/program/temporary_folder.hpp"

namespace mayfly::test {

// Twelve agents that never rest; stopping takes them four of their 5 ms periods.
std::string write_restless_scenario(const TemporaryFolder& folder);

// CLOCK_MONOTONIC.
Time monotonic_now();

class TwoProcesses {
 public:
  // `arguments` after those that fly the restless scenario with a guard of its own.
  explicit TwoProcesses(const std::vector<std::string>& arguments = {});

  // Waits until both fly. False where the planner ends before.
  bool fly();
  // Waits until the planner's heart has beaten so often since.
  bool wait_for_beats(std::uint64_t beats);
  // Waits until the guard has brought everybody to stand still because the wish ran out, later than `after`:
  // when, on CLOCK_MONOTONIC, and how late the machine was meanwhile. Empty where the guard ends before.
  struct Stopped {
    Time still{0}, late{0};
  };
  std::optional<Stopped> wait_for_stop(Time after);
  link::Header& header() const { return segment_->header(); }
  // A copy of the guard's descriptor of the segment.
  int segment_descriptor() const;

  pid_t planner() const;
  pid_t guard() const;
  void send_planner(int signal) const { planner_.send(signal); }
  void send_guard(int signal) const;

  // Until both have ended.
  Outcome wait() { return planner_.wait(); }
  // After that; discarded where there is none.
  nlohmann::json guard_report() const { return json("guard.json"); }
  nlohmann::json summary() const { return json("summary.json"); }

 private:
  nlohmann::json json(const std::string& file) const;

  TemporaryFolder folder_;
  Process planner_;
  std::optional<link::Segment> segment_;
};

}  // namespace mayfly::test
