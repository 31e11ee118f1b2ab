// What a run is held to.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "controller/faults/fault_table.hpp"
#include "controller/safety/symptoms.hpp"

namespace mayfly {

struct Expectation {
  enum class Quantity {
    kReached,
    kMinSeparation,
    kPenetrations,
    kCollisions,
    kMdePercent,
    kMaxSpeed,
    kMaxAcceleration,
    kGovernorInterventions,
    kMissed,
    kFaults,
    kFieldAge,          // s, the oldest field that was flown by
    kWallClearance,     // m, the least distance of an agent's centre to an obstacle
    kCentreDrift,       // m, the farthest that a swarm's centre was from where it started
    kGoalDistance,      // m, mean over agents and the flight's second half
    kTurns,             // mean |turns| of an agent about a vertical axis
    kSpread,            // m, radius of gyration, mean of the flight's last tenth
    kPolarisation,      // |mean unit velocity|, mean of the flight's second half
    kMilling,           // |mean unit angular momentum about the centre, vertical|, mean of the second half
    kNearest,           // m, mean distance to the nearest of the swarm, of the second half
    kStimulusDistance,  // m, mean over agents and the flight's second half
    kArrived,           // share of the swarm's agents within `within` of a stimulus
    kClearing,          // m, the least distance of any agent to a stimulus, at any tick
    kParting,           // the largest spread from an encounter with a stimulus on, by that at its start
    kClosing,           // the spread of the flight's last tenth, by that at the start of the encounter
    kNoticed,           // s, the longest from a fault's begin until its symptom was reported
    kInfeasible,        // share of the agent-ticks of swarms with avoidance
    kReacted,           // s, the longest from a fault's begin until a reaction as severe as `severity`
    kSafetyBreaches     // of all that is promised of the robots, by their true places
  };
  enum class Comparison { kGreaterEqual, kLessEqual, kEqual, kGreater, kLess };
  Quantity quantity = Quantity::kPenetrations;
  std::string swarm;  // of those that have one; empty for all
  std::string goal;   // kReached, kGoalDistance; empty: each swarm's own
  Comparison comparison = Comparison::kEqual;
  double wanted = 0.0;
  std::string text;                     // as written, for the summary: "reached flies at exit"
  std::optional<glm::vec3> around{};    // m, kTurns only: where the axis stands
  std::string stimulus{};               // of those that are about one
  float within = 0.0F;                  // m, kArrived only
  FaultKind fault = FaultKind::kCount;  // kNoticed, kReacted
  Severity severity = Severity::kNone;  // kReacted only
  std::optional<double> at{};           // s, kArrived only: when; empty: at the flight's end
};

}  // namespace mayfly
