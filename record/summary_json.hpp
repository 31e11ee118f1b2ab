// The summary file, whose keys are a contract.
#pragma once

#include <string>

#include "controller/flight/summary.hpp"

namespace mayfly::record {

// JSON, SI units, two spaces of indentation, a newline at the end. What was not measured is null, and so is
// what is not a finite number: JSON has no NaN.
std::string to_json(const Summary& summary);

}  // namespace mayfly::record
