// The engines in the locusts' village, beside the paper as it is printed.
#include <algorithm>
#include <chrono>
#include <limits>

#include "bench/common/ticks.hpp"
#include "bench/fields/measure.hpp"
#include "bench/fields/village.hpp"
#include "bench/fields/wang14_scalar.hpp"

namespace mayfly::bench {
namespace {

constexpr std::size_t kPaper = 5000;   // Wang14 Table 1
constexpr std::size_t kGpu = 256'000;  // what the paper's GPU holds in real time

double scalar_seconds(const Village& village, int ticks, bool tabulated) {
  const World& world = village.ready->world;
  const fields::CostField& cost = *world.costs.front();
  std::vector<float> costs(world.grid.size());
  for (std::size_t cell = 0; cell < costs.size(); ++cell) {
    costs[cell] = cost.kind[cell] == fields::CellKind::kReached ? cost.guide[4 * cell + 3]
                                                                : std::numeric_limits<float>::infinity();
  }
  const SwarmSpec& swarm = village.scenario.swarms.front();
  Wang14Scalar baseline(world.grid, world.distance.distance, costs,
                        {.scale = swarm.noise.octaves.front().scale,
                         .gain = swarm.noise.octaves.front().gain,
                         .cruise_speed = swarm.cruise_speed,
                         .min_distance = swarm.limits.separation,
                         .mde_sweeps = swarm.mde_sweeps,
                         .tabulated = tabulated});
  baseline.place(village.ready->places);
  std::vector<double> seconds;
  for (int tick = 0; tick < ticks; ++tick) {
    const auto start = std::chrono::steady_clock::now();
    baseline.step(1.0F / village.scenario.control.rate);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(seconds.begin(), seconds.begin() + ticks / 4, seconds.end());
  return seconds[static_cast<std::size_t>(ticks / 4)];
}

// One row for a native engine in a village; without `wanted` it informs.
Result<Row> native_row(const FieldsPlan& plan, const Village& village, int threads) {
  const auto engine = make_native_engine(threads);
  const auto ticks = time_ticks(*engine, flock_of(village), plan.ticks);
  if (!ticks) {
    return fail(ticks.error());
  }
  const auto agents = village.ready->models.agents();
  Row row;
  row.key = "native_" + std::to_string(agents) + "_threads_" + std::to_string(threads);
  row.what = std::to_string(agents) + " locusts, native engine, " + std::to_string(threads) +
             (threads == 1 ? " thread" : " threads");
  row.value = 1.0 / ticks->seconds;
  row.unit = "ticks/s";
  row.less_is_better = false;
  return row;
}

void add_ns_per_agent(const Row& speed, std::size_t agents, Report& report) {
  report.rows.push_back({.key = speed.key + "_ns",
                         .what = "  of it an agent",
                         .value = 1e9 / speed.value / static_cast<double>(agents),
                         .unit = "ns"});
}

Result<void> compare_with_paper(const FieldsPlan& plan, const Village& village, Report& report) {
  auto ours = native_row(plan, village, 1);
  if (!ours) {
    return fail(std::move(ours.error()));
  }
  const double scalar = scalar_seconds(village, plan.ticks, false);
  ours->baseline = "the paper as printed, scalar";
  ours->baseline_value = 1.0 / scalar;
  ours->wanted = 8.0 / scalar;
  report.rows.push_back(*ours);
  add_ns_per_agent(*ours, village.ready->models.agents(), report);
  ours->key += "_tabulated";
  ours->what = "  beside the same with N tabulated on 1 m cells, aliased";
  ours->wanted.reset();
  ours->baseline_value = 1.0 / scalar_seconds(village, plan.ticks, true);
  report.rows.push_back(std::move(*ours));
  return {};
}

Result<void> add_opencl(const FieldsPlan& plan, const Village& village, double native, Report& report) {
  auto engine = make_opencl_engine();
  if (!engine) {
    return {};  // a machine without OpenCL has one row less
  }
  const auto ticks = time_ticks(**engine, flock_of(village), plan.ticks);
  if (!ticks) {
    return fail(ticks.error());
  }
  const std::string agents = std::to_string(village.ready->models.agents());
  report.rows.push_back({.key = "opencl_" + agents,
                         .what = agents + " locusts, OpenCL engine",
                         .value = 1.0 / ticks->seconds,
                         .unit = "ticks/s",
                         .less_is_better = false,
                         .baseline = "native",
                         .baseline_value = native});
  return {};
}

tl::expected<void, std::vector<Error>> measure_crowd(const FieldsPlan& plan, std::size_t agents,
                                                     std::optional<double> wanted, Report& report) {
  const auto village = make_village({.agents = agents, .everywhere = true, .threads = plan.threads});
  if (!village) {
    return tl::unexpected(village.error());
  }
  auto row = native_row(plan, *village, plan.threads);
  if (!row) {
    return tl::unexpected(std::vector{std::move(row.error())});
  }
  row->wanted = wanted;
  report.rows.push_back(*row);
  add_ns_per_agent(*row, agents, report);
  if (auto added = add_opencl(plan, *village, row->value, report); !added) {
    return tl::unexpected(std::vector{std::move(added.error())});
  }
  return {};
}

}  // namespace

tl::expected<void, std::vector<Error>> measure_engines(const FieldsPlan& plan, Report& report) {
  const auto paper = make_village({.agents = std::min(kPaper, plan.most_agents), .threads = plan.threads});
  if (!paper) {
    return tl::unexpected(paper.error());
  }
  if (auto compared = compare_with_paper(plan, *paper, report); !compared) {
    return tl::unexpected(std::vector{std::move(compared.error())});
  }
  const auto measured = [&](std::size_t agents, std::optional<double> wanted) {
    return agents > plan.most_agents ? tl::expected<void, std::vector<Error>>{}
                                     : measure_crowd(plan, agents, wanted, report);
  };
  return measured(300, {})
      .and_then([&] { return measured(kPaper, {}); })
      .and_then([&] { return measured(kGpu, 60.0); })
      .and_then([&] { return measured(1'000'000, 15.0); });
}

}  // namespace mayfly::bench
