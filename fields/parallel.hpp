// A loop over independent pieces of work, for what is computed before the flight.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "core/progress.hpp"

namespace mayfly::fields {

// Calls work(i) once for each i in [0, count), on up to `threads` threads (< 1: all cores), in any order.
// Returns when all are done. `progress` is called from the calling thread, a few times a second. `work` must
// not throw.
void parallel_for(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                  const std::function<void(std::size_t)>& work);

}  // namespace mayfly::fields
