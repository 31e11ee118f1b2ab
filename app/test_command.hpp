// mayfly test
#pragma once

#include "app/arguments.hpp"

namespace mayfly::app {

// Flies scenarios on the virtual clock and holds them to their `expect` lines, one line of output each.
// Returns the exit code.
int test(const TestOptions& options);

}  // namespace mayfly::app
