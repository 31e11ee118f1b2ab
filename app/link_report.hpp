// What the guard's process saw, as a file.
#pragma once

#include <filesystem>

#include "controller/link/guard_loop.hpp"
#include "core/result.hpp"

namespace mayfly::app {

// JSON. Times are nanoseconds of CLOCK_MONOTONIC, to be compared with other processes': `epoch` is the run's
// time 0 there.
Result<void> write_link_report(const std::filesystem::path& path, const link::LinkReport& report, Time epoch);

}  // namespace mayfly::app
