// mayfly guard
#pragma once

#include "app/arguments.hpp"

namespace mayfly::app {

// Owns the robots until a planner ends, however it ends, and longer: until they rest. Returns the exit code.
int guard(const GuardOptions& options);

}  // namespace mayfly::app
