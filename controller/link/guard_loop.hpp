// The guard's side of a flight in two processes: its ticks, and what it does when the planner goes.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/executor/executor.hpp"
#include "controller/flight/fault_log.hpp"
#include "controller/guard/guard.hpp"
#include "controller/link/flight_end.hpp"
#include "controller/link/guard_end.hpp"
#include "core/clock.hpp"

namespace mayfly::link {

// Once that the planner's wish ran out, or was void, and everybody was told to stand still. Times on the
// run's clock.
struct Stop {
  Time wished{0};  // when the planner issued its last wish
  Time still{0};   // when the last robot was told to hold, or velocity 0
  Time late{0};    // by how much the machine woke the guard too late meanwhile, all together
};

struct LinkReport {
  bool planner_died = false;  // it did not ask for the end
  std::uint64_t ticks = 0;
  std::uint64_t skipped = 0;  // releases that no tick served
  std::uint64_t wishes = 0;   // taken
  std::uint64_t refused = 0;
  std::uint64_t leases_refused = 0;  // second planners, and second guards
  Time planner_gone{0};              // when its end was noticed; 0 where it asked for the end
  std::vector<Stop> stops;           // the first of them
  // µs by which a bare thread beside the guard's was woken late; empty: not measured.
  std::optional<Percentiles> witness;
};

struct GuardParts {
  Guard& guard;
  GuardEnd& end;
  Clock& clock;
  // Set by whoever watches the planner's process, from any thread.
  const std::atomic<bool>& planner_gone;
  // The guard's own signals, as mayfly::StopRequest: the same terminal interrupts both.
  const std::atomic<int>& asked_to_stop;
};

// One thread. A tick allocates nothing.
class GuardLoop {
 public:
  explicit GuardLoop(const GuardParts& parts);

  void tick(const TickInfo& info) noexcept;
  // The robots rest, and may be let go.
  const std::atomic<bool>& finished() const noexcept { return finished_; }
  // When tick() is not called any more.
  LinkReport report() const;

 private:
  static constexpr std::size_t kMostStops = 64;

  CommandColumns next_wish(Time now) noexcept;
  void heed_operator() noexcept;
  void land() noexcept;
  void note(FaultLog::Source& source, Time now, const HalResult& result) noexcept;
  void tell_reactions() noexcept;
  void account(const TickInfo& info, Time now) noexcept;
  bool all_told_to_stand() const noexcept;
  FlightEnd::Seen seen() const noexcept;
  void show(Time now) noexcept;

  GuardParts parts_;
  FlightEnd end_;
  FaultLog::Source sense_source_, act_source_;
  LinkReport report_;
  std::size_t reactions_told_ = 0;
  std::uint32_t acknowledged_ = 0;
  Time wish_until_{0};
  // Of the stop that may begin at any tick, from the last wish on.
  Stop stop_;
  bool stop_is_told_ = true;
  Time worst_wake_{0}, skipped_since_{0};
  std::uint64_t taken_before_ = 0;
  std::atomic<bool> finished_{false};
};

}  // namespace mayfly::link
