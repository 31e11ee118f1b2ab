#include "controller/flight/timing_summary.hpp"

namespace mayfly {
namespace {

std::optional<LatencySummary> told(const std::optional<Percentiles>& p) {
  return p ? std::optional(LatencySummary{p->p50, p->p99, p->p999, p->max}) : std::nullopt;
}

TaskSummary told(const TaskStats& task, bool is_virtual) {
  return {task.name,
          task.own_thread ? "own" : "control",
          task.rate_hz,
          task.ticks,
          task.missed,
          task.missed_by_machine,
          is_virtual ? std::nullopt : told(task.jitter),
          told(task.run)};
}

AgeSummary told(const AgeStats& age) {
  AgeSummary summary{age.name, to_seconds(age.limit), age.expired, std::nullopt};
  if (age.read > age.missing) {
    summary.age_s = Spread{to_seconds(age.p50), to_seconds(age.p99), to_seconds(age.max)};
  }
  return summary;
}

}  // namespace

ControlSummary control_summary(const Executor& executor, const FlightRights* rights,
                               std::span<const AgeStats> ages) {
  ControlSummary summary;
  for (const TaskStats& task : executor.stats()) {
    summary.tasks.push_back(told(task, rights == nullptr));
  }
  const TaskSummary& control = summary.tasks.front();
  summary.rate_hz = control.rate_hz;
  summary.ticks = control.ticks;
  summary.missed = control.missed;
  summary.missed_by_machine = control.missed_by_machine;
  summary.jitter_us = control.jitter_us;
  summary.run_us = control.run_us;
  if (rights != nullptr) {
    summary.realtime = rights->granted().complete() ? "granted" : "degraded";
    summary.missing_rights = rights->missing();
  }
  summary.witness_us = told(executor.witness().oversleep());
  for (const AgeStats& age : ages) {
    summary.ages.push_back(told(age));
  }
  return summary;
}

}  // namespace mayfly
