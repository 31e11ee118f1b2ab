// Collision avoidance, beside RVO2-3D where CMake was given -DMAYFLY_RVO2_3D=<its source folder>.

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "bench/forces/even_swarm.hpp"
#include "bench/forces/measure.hpp"

namespace mayfly::bench {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr float kCompany = 20.0F;
constexpr std::size_t kMany = 100'000;
constexpr std::size_t kFew = 50;
constexpr int kRounds = 12;  // of each measurement; the least counts

Row row_of(std::string key, std::string what, double value, std::string unit) {
  Row row;
  row.key = std::move(key);
  row.what = std::move(what);
  row.value = value;
  row.unit = std::move(unit);
  return row;
}

// Ours and RVO2-3D's, in turns, so that both see the same machine.
struct SideBySide {
  double ours_s = kNever;
  std::array<double, 2> rvo2_s{kNever, kNever};  // agents as they come, and along a Morton curve
};

Result<SideBySide> run_side_by_side(int threads, const EvenSwarm& swarm) {
  SideBySide least;
  const auto engine = make_native_engine(threads);
#ifdef MAYFLY_HAS_RVO2_3D
  Rvo2Swarm as_they_come(swarm, threads, false);
  Rvo2Swarm along_a_curve(swarm, threads, true);
#endif
  constexpr int kTicksInTurn = 3;
  for (int round = 0; round < kRounds; round += kTicksInTurn) {
    const auto ours = tick_seconds(*engine, swarm, kTicksInTurn);
    if (!ours) {
      return fail(ours.error());
    }
    least.ours_s = std::min(least.ours_s, *ours);
#ifdef MAYFLY_HAS_RVO2_3D
    least.rvo2_s[0] = std::min(least.rvo2_s[0], as_they_come.step_seconds());
    least.rvo2_s[1] = std::min(least.rvo2_s[1], along_a_curve.step_seconds());
#endif
  }
  return least;
}

void add_peer(Row row, const std::string& key, const std::string& who, double seconds, double factor,
              double agents, Report& report) {
  row.key += key;
  row.baseline = who;
  row.baseline_value = 1e6 * seconds / agents;
  row.wanted = *row.baseline_value / factor;
  report.rows.push_back(std::move(row));
}

}  // namespace

Result<void> measure_avoidance_rows(const ForcesPlan& plan, Report& report) {
  const EvenSwarm swarm(plan.at_most(kMany), EvenSwarm::kRange, kCompany);
  const auto agents = static_cast<double>(swarm.x.size());
  const auto least = run_side_by_side(plan.threads, swarm);
  const auto strict = tick_seconds(*make_native_engine(plan.threads), swarm, kRounds, true);
  const auto few = tick_seconds(*make_native_engine(1), {kFew, EvenSwarm::kRange, kCompany}, 50 * kRounds);
  if (!least || !strict || !few) {
    return fail(!least ? least.error() : !strict ? strict.error() : few.error());
  }
  const Row ours = row_of(
      "avoidance", std::to_string(swarm.x.size()) + " agents keep clear of 10 of about 20 in range, an agent",
      1e6 * least->ours_s / agents, "µs");
  report.rows.push_back(ours);
  if (least->rvo2_s[0] < kNever) {
    add_peer(ours, "_rvo2", "RVO2-3D", least->rvo2_s[0], 10.0, agents, report);
    add_peer(ours, "_rvo2_morton", "RVO2-3D, agents along a Morton curve", least->rvo2_s[1], 5.0, agents,
             report);
  }
  report.rows.push_back(row_of("avoidance_strict", "  the same, strict", 1e6 * *strict / agents, "µs"));
  Row small =
      row_of("avoidance_few", "50 agents keep clear of each other, 1 thread, a tick", 1e6 * *few, "µs");
  small.wanted = 60.0;
  report.rows.push_back(std::move(small));
  return {};
}

}  // namespace mayfly::bench
