#include "bench/governor/measure.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "bench/governor/estimator_time.hpp"
#include "bench/governor/trial.hpp"

namespace mayfly::bench {
namespace {

constexpr std::size_t kAgents = 50;
constexpr double kSeparation = 0.2;  // m, two bodies
constexpr std::uint64_t kParts = 4;  // of the attack: no latency, and one to three ticks of it

std::uint64_t ticks_of(double seconds) {
  return static_cast<std::uint64_t>(seconds * 100.0);
}

// All that went wrong in several trials.
void add(TrialResult& sum, const TrialResult& trial) {
  sum.agent_ticks += trial.agent_ticks;
  sum.least_gap = sum.samples == 0 ? trial.least_gap : std::min(sum.least_gap, trial.least_gap);
  sum.samples += trial.samples;
  sum.near_samples += trial.near_samples;
  sum.too_fast += trial.too_fast;
  sum.too_sudden += trial.too_sudden;
  sum.outside += trial.outside;
  sum.goals += trial.goals;
  sum.travelled += trial.travelled;
}

Row breaches(const std::string& key, const std::string& what, std::uint64_t count) {
  return {.key = key, .what = what, .value = static_cast<double>(count), .unit = "", .wanted = 0.0};
}

Result<void> add_attack(const GovernorPlan& plan, Report& report) {
  TrialResult sum;
  for (std::uint64_t part = 0; part < kParts; ++part) {
    const TrialPlan trial{.agents = kAgents,
                          .ticks = ticks_of(plan.attack_s) / kParts,
                          .seed = 1 + part,
                          .latency = static_cast<int>(part),
                          .pose_noise = 0.01,
                          .dropout = 0.02,
                          .uneven = part % 2 == 1};
    const auto result = run_trial(trial);
    if (!result) {
      return fail(result.error());
    }
    add(sum, *result);
    plan.tell("attack", static_cast<double>(part + 1) / kParts);
  }
  report.rows.push_back({.key = "attack_agent_ticks",
                         .what = "hostile commands, noise, latency, dropouts: agent-ticks",
                         .value = static_cast<double>(sum.agent_ticks),
                         .unit = "",
                         .less_is_better = false});
  report.rows.push_back(
      breaches("attack_separation", "  of them, samples with two bodies overlapping", sum.near_samples));
  report.rows.push_back(breaches("attack_speed", "  commands above the speed limit", sum.too_fast));
  report.rows.push_back(
      breaches("attack_acceleration", "  commands above the acceleration limit", sum.too_sudden));
  report.rows.push_back(breaches("attack_fence", "  bodies outside the fence", sum.outside));
  report.rows.push_back({.key = "attack_least_gap",
                         .what = "  least gap between two bodies",
                         .value = sum.least_gap,
                         .unit = "m",
                         .wanted = 0.0,
                         .less_is_better = false});
  report.rows.push_back({.key = "attack_speed_mean",
                         .what = "  mean speed: they do not simply stand",
                         .value = sum.travelled / static_cast<double>(sum.agent_ticks) / 0.01,
                         .unit = "m/s",
                         .wanted = 0.05,
                         .less_is_better = false});
  return {};
}

// Collision avoidance alone and before the governor, on the same wishes.
Result<void> add_avoidance(const GovernorPlan& plan, Wishes wishes, const std::string& key,
                           const std::string& what, Report& report) {
  TrialPlan trial{.agents = kAgents, .ticks = ticks_of(plan.goals_s), .seed = 5, .wishes = wishes};
  const auto governed = run_trial(trial);
  trial.governed = false;
  const auto alone = run_trial(trial);
  if (!governed || !alone) {
    return fail((governed ? alone : governed).error());
  }
  report.rows.push_back({.key = key + "_least_distance",
                         .what = "ORCA before the governor, " + what + ": least distance",
                         .value = kSeparation + governed->least_gap,
                         .unit = "m",
                         .wanted = kSeparation,
                         .less_is_better = false,
                         .baseline = "ORCA alone",
                         .baseline_value = kSeparation + alone->least_gap});
  const auto clear_share = [](const TrialResult& flown) {
    return 1.0 - static_cast<double>(flown.near_samples) / static_cast<double>(flown.samples);
  };
  report.rows.push_back({.key = key + "_clear",
                         .what = "  share of the samples in which no bodies overlap",
                         .value = clear_share(*governed),
                         .unit = "",
                         .wanted = 1.0,
                         .less_is_better = false,
                         .baseline = "ORCA alone",
                         .baseline_value = clear_share(*alone)});
  plan.tell(key, 1.0);
  return {};
}

Result<void> add_progress(const GovernorPlan& plan, Report& report) {
  TrialResult with;
  TrialResult without;
  for (const std::uint64_t seed : {11U, 12U, 13U}) {
    TrialPlan trial{
        .agents = kAgents, .ticks = ticks_of(plan.goals_s), .seed = seed, .wishes = Wishes::kGoals};
    const auto governed = run_trial(trial);
    trial.governed = false;
    const auto alone = run_trial(trial);
    if (!governed || !alone) {
      return fail((governed ? alone : governed).error());
    }
    add(with, *governed);
    add(without, *alone);
  }
  report.rows.push_back({.key = "goals_share",
                         .what = "random goals reached with the governor, of those without",
                         .value = static_cast<double>(with.goals) / static_cast<double>(without.goals),
                         .unit = "",
                         .wanted = 0.97,
                         .less_is_better = false});
  report.rows.push_back({.key = "goals",
                         .what = "  that is",
                         .value = static_cast<double>(with.goals),
                         .unit = "goals",
                         .less_is_better = false,
                         .baseline = "ORCA alone",
                         .baseline_value = static_cast<double>(without.goals)});
  plan.tell("goals", 1.0);
  return {};
}

Result<void> add_times(const GovernorPlan& plan, Report& report) {
  for (const std::size_t agents : {std::size_t{50}, std::size_t{500}}) {
    const auto hostile =
        run_trial({.agents = agents, .ticks = std::min<std::uint64_t>(ticks_of(plan.goals_s), 1000)});
    if (!hostile) {
      return fail(hostile.error());
    }
    report.rows.push_back({.key = "tick_" + std::to_string(agents),
                           .what = std::to_string(agents) + " robots under attack, a tick, one thread",
                           .value = 1e6 * hostile->governor_seconds,
                           .unit = "us",
                           .wanted = agents == 50 ? 50.0 : 1000.0});
    report.rows.push_back({.key = "estimator_" + std::to_string(agents),
                           .what = "  the estimator before it",
                           .value = 1e6 * estimator_seconds(agents, 1000),
                           .unit = "us"});
  }
  return {};
}

}  // namespace

Result<Report> measure_governor(const GovernorPlan& plan) {
  Report report{.bench = "governor",
                .title = "The governor under attack, its cost in progress and in time",
                .rows = {},
                .curves = {}};
  const auto start = std::chrono::steady_clock::now();
  auto done = add_attack(plan, report)
                  .and_then([&] {
                    return add_avoidance(plan, Wishes::kCentre, "centre", "all to the centre", report);
                  })
                  .and_then([&] {
                    return add_avoidance(plan, Wishes::kChase, "chase", "all chase the nearest", report);
                  })
                  .and_then([&] { return add_progress(plan, report); })
                  .and_then([&] { return add_times(plan, report); });
  if (!done) {
    return fail(std::move(done.error()));
  }
  report.took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace mayfly::bench
