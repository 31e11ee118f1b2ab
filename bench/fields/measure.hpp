// `mayfly bench fields`: the field core in numbers, each beside its baseline in the same run.
#pragma once

#include <cstddef>
#include <vector>

#include "bench/common/report.hpp"
#include "core/progress.hpp"

namespace mayfly::bench {

struct FieldsPlan {
  std::size_t most_agents = 1U << 20U;
  int largest_grid = 200;  // cells along a side, of the solvers' worlds
  int torus_triangles = 70'000;
  int ticks = 40;  // a measurement of an engine or a baseline: the lower quartile counts
  int threads = 2;
  Progress progress{};
};

tl::expected<Report, std::vector<Error>> measure_fields(const FieldsPlan& plan);

// Its parts; each appends to the report.
Result<void> measure_noise(const FieldsPlan& plan, Report& report);
void measure_eikonal(const FieldsPlan& plan, Report& report);
Result<void> measure_solvers(const FieldsPlan& plan, Report& report);
tl::expected<void, std::vector<Error>> measure_engines(const FieldsPlan& plan, Report& report);
tl::expected<void, std::vector<Error>> measure_growth(const FieldsPlan& plan, Report& report);

}  // namespace mayfly::bench
