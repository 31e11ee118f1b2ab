// `mayfly bench forces`: forces, collision avoidance and the search for neighbours in numbers, each beside
// its baseline in the same run.
#pragma once

#include <algorithm>
#include <cstddef>

#include "bench/common/report.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct ForcesPlan {
  std::size_t most_agents = 200'000;  // of any row: a trial has few
  int ticks = 40;                     // a measurement of an engine: the lower quartile counts
  int threads = 2;
  Progress progress{};

  std::size_t at_most(std::size_t agents) const { return std::min(agents, most_agents); }
};

Result<Report> measure_forces(const ForcesPlan& plan);

// Its parts; each appends to the report.
Result<void> measure_force_rows(const ForcesPlan& plan, Report& report);
Result<void> measure_avoidance_rows(const ForcesPlan& plan, Report& report);
Result<void> measure_phase_rows(const ForcesPlan& plan, Report& report);
Result<void> measure_neighbour_rows(const ForcesPlan& plan, Report& report);

}  // namespace mayfly::bench
