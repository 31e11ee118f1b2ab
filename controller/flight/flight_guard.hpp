// What a flight's guard is told of the scenario, and what the summary is told of the guard.
#pragma once

#include <span>
#include <vector>

#include "controller/flight/motion.hpp"
#include "controller/flight/summary.hpp"
#include "controller/flight/world.hpp"
#include "controller/guard/guard_config.hpp"
#include "controller/guard/guard_port.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// As governor_config(): world and motion must outlive it. `clock`, the run's, must too: where real time is
// enforced, the guard watches how late its ticks are.
GuardConfig guard_config(const Scenario& scenario, const World& world, const Motion& motion,
                         const Clock& clock);

SafetySummary told_of(const GuardPort& guard);

// The guard's reactions as faults, with those that others saw, in the order of time. `began`: of the flight,
// on the run's clock.
std::vector<FaultEvent> with_reactions(std::vector<FaultEvent> faults, const GuardPort& guard, Time began);

}  // namespace mayfly
