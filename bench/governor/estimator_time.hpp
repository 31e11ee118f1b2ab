// What it costs to know where the robots are.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mayfly::bench {

// s: the lower quartile of a tick of the estimator, all gates on, with one noisy pose of each robot a tick.
// One thread.
double estimator_seconds(std::size_t robots, std::uint64_t ticks);

}  // namespace mayfly::bench
