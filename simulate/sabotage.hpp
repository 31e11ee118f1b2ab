// What a scenario lets go wrong beside the robots: with the planner, the clock and the operator.
#pragma once

#include <atomic>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/flight/flight.hpp"
#include "controller/guard/guard_port.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/clock.hpp"

namespace mayfly::simulate {

// Stands in for a flight's engine, clock and stop request, and before its guard. Where a scenario has no such
// faults it hands out those that it was given. All of them, and the scenario, outlive it. Everything follows
// from the scenario's seed and the flight's time.
class Sabotage {
 public:
  Sabotage(const Scenario& scenario, Engine& engine, Clock& clock, const StopRequest* stop);
  Sabotage(const Sabotage&) = delete;
  Sabotage& operator=(const Sabotage&) = delete;
  ~Sabotage();

  Engine& engine() const;
  // What the planner has for its guard (FlightParts::between); null where it is the guard itself.
  std::unique_ptr<GuardPort> before(GuardPort& guard) const;
  Clock& clock() const;
  const StopRequest* stop() const;

 private:
  struct State;
  class BadEngine;
  class BadClock;

  const Scenario& scenario_;
  Engine& engine_;
  Clock& clock_;
  const StopRequest* stop_;
  std::unique_ptr<State> state_;
  std::unique_ptr<BadClock> bad_clock_;    // none where nothing is wrong with it
  std::unique_ptr<BadEngine> bad_engine_;  // none likewise
};

// Where the agents start, with those moved that `start_too_near` moves. m, one an agent.
std::vector<glm::vec3> start_places(const Scenario& scenario, std::span<const glm::vec3> places);

}  // namespace mayfly::simulate
