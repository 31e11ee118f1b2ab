// What a flight came to, for reading.
#pragma once

#include <string>

#include "controller/flight/summary.hpp"

namespace mayfly::app {

// Several lines, each ending in a newline. `real_time`: with the figures of punctuality.
std::string summary_table(const Summary& summary, bool real_time);

}  // namespace mayfly::app
