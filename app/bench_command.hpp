// mayfly bench
#pragma once

#include "app/arguments.hpp"

namespace mayfly::app {

// Returns the exit code: 0 whatever is measured.
int bench(const BenchOptions& options);

}  // namespace mayfly::app
