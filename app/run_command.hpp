// mayfly run
#pragma once

#include "app/arguments.hpp"

namespace mayfly::app {

// Returns the exit code.
int run(const RunOptions& options);

}  // namespace mayfly::app
