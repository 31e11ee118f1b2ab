// `mayfly bench guard`: what a tick of the guard costs, and which part of it.
#pragma once

#include <cstddef>

#include "bench/common/report.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct GuardPlan {
  std::size_t most_agents = 500;  // of the larger of the two swarms; the other has a tenth
  int ticks = 2000;               // of each
  Progress progress{};
};

// Medians of the CPU time of one thread. Robots obey at once, nothing fails.
Result<Report> measure_guard(const GuardPlan& plan);

}  // namespace mayfly::bench
