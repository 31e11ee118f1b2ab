// How soon what goes wrong is noticed: a scenario's faults beside the events of its flight.
#pragma once

#include <optional>
#include <vector>

#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// s from the fault's begin to the first event that tells of its symptom, of one whom it strikes or of
// everybody; empty where there is none.
std::optional<double> noticed_after(const Scenario& scenario, const FaultSpec& fault,
                                    const std::vector<FaultEvent>& events);

// s from the fault's begin to the first reaction at least as severe, for one whom it strikes or for
// everybody; empty where there is none.
std::optional<double> reacted_after(const Scenario& scenario, const FaultSpec& fault, Severity at_least,
                                    const std::vector<FaultEvent>& events);

// The longest of all faults of the kind; empty where one was not noticed (or answered), or there is none.
std::optional<double> noticed_after(const Scenario& scenario, FaultKind kind,
                                    const std::vector<FaultEvent>& events);
std::optional<double> reacted_after(const Scenario& scenario, FaultKind kind, Severity at_least,
                                    const std::vector<FaultEvent>& events);

}  // namespace mayfly
