// One flight from arming to standstill: read → estimate → engine → guard → write, at a fixed rate.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "controller/engine/engine.hpp"
#include "controller/flight/observer.hpp"
#include "controller/flight/summary.hpp"
#include "controller/flight/world.hpp"
#include "controller/guard/exchange.hpp"
#include "controller/guard/guard_port.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/clock.hpp"
#include "core/hal.hpp"

namespace mayfly {

// Set from a signal handler: 1 asks the swarm to hold and then the flight to end, 2 or more is the emergency
// stop.
using StopRequest = std::atomic<int>;

// True state for metrics and observers, where the HAL knows it (simulation). Columns as in StateColumns; may
// be empty.
class GroundTruth {
 public:
  virtual ~GroundTruth() = default;
  virtual void truth(const StateColumns& columns) const noexcept = 0;
  // Of what is promised of them, so far; empty where nobody looks.
  virtual std::optional<BreachSummary> breaches() const noexcept { return std::nullopt; }
};

// How far a flight is, for whoever shows it; written by the control thread, read by any.
struct FlightGauge {
  std::atomic<Time::rep> flown_ns{0};
  std::atomic<std::uint64_t> faults{0};
};

struct FlightParts {
  const Scenario& scenario;
  const World& world;
  Engine& engine;  // prepared for this scenario's swarms
  Hal& hal;        // one robot an agent, in the scenario's order; not yet configured
  const GroundTruth* truth = nullptr;
  Clock& clock;
  std::span<Observer* const> observers{};
  const StopRequest* stop = nullptr;
  FlightGauge* gauge = nullptr;
  // Where the guard is somewhere else (another process): then `hal` is not touched, but for its name.
  GuardPort* guard = nullptr;
  // Puts something between the planner and its guard, for the whole flight; may answer null. Simulated faults
  // of planners do.
  std::function<std::unique_ptr<GuardPort>(GuardPort&)> between{};
  // Takes robots of `hal` out of the run and puts them back; null where nobody does.
  Exchange* exchange = nullptr;
  // Called when all is over, where the guard's black box has kept something (docs/explanation/guard.md).
  std::function<void(const BlackBoxTape&)> keep_tape{};
};

// Flies the scenario to its end. An error means that nothing flew (the HAL refused); faults in flight are in
// the summary.
Result<Summary> fly(const FlightParts& parts);

}  // namespace mayfly
