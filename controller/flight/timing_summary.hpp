// From what the executor measured to the `control` part of a summary.
#pragma once

#include <span>

#include "controller/executor/executor.hpp"
#include "controller/executor/handover.hpp"
#include "controller/flight/flight_rights.hpp"
#include "controller/flight/summary.hpp"

namespace mayfly {

// The first task is control. `rights` is null on a virtual clock; `ages`: one a value that crossed tasks.
ControlSummary control_summary(const Executor& executor, const FlightRights* rights,
                               std::span<const AgeStats> ages);

}  // namespace mayfly
