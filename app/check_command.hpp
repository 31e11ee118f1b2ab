// mayfly check
#pragma once

#include "app/arguments.hpp"

namespace mayfly::app {

// Returns the exit code.
int check(const CheckOptions& options);

}  // namespace mayfly::app
