// The executor at a fixed rate in real time, with a tick's worth of work, a planner beside it, and the
// witness of the machine's own lateness, as `mayfly run` would use it. Prints the `control` part of a summary
// (docs: the summary file). bench/realtime/compare runs it beside cyclictest.
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "bench/realtime/loop_load.hpp"
#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/realtime_rights.hpp"
#include "controller/executor/executor.hpp"

namespace {

void print(const char* name, const mayfly::Percentiles& p, const char* end) {
  std::printf("\"%s\": {\"p50\": %.3f, \"p99\": %.3f, \"p999\": %.3f, \"max\": %.3f}%s", name, p.p50, p.p99,
              p.p999, p.max, end);
}

void print(const mayfly::TaskStats& task, const char* end) {
  std::printf(
      "{\"name\": \"%s\", \"thread\": \"%s\", \"rate_hz\": %g, \"ticks\": %llu, \"missed\": %llu, "
      "\"missed_by_machine\": %llu, ",
      task.name.c_str(), task.own_thread ? "own" : "control", task.rate_hz,
      static_cast<unsigned long long>(task.ticks), static_cast<unsigned long long>(task.missed),
      static_cast<unsigned long long>(task.missed_by_machine));
  print("jitter_us", task.jitter.value_or(mayfly::Percentiles{}), ", ");
  print("run_us", task.run.value_or(mayfly::Percentiles{}), end);
}

// `control` is the first task once more: what a summary's reader looks for.
void print(const mayfly::Executor& executor) {
  const auto tasks = executor.stats();
  const mayfly::TaskStats& control = tasks.front();
  std::printf(
      "{\"control\": {\"rate_hz\": %g, \"ticks\": %llu, \"missed\": %llu, \"missed_by_machine\": %llu, ",
      control.rate_hz, static_cast<unsigned long long>(control.ticks),
      static_cast<unsigned long long>(control.missed),
      static_cast<unsigned long long>(control.missed_by_machine));
  print("jitter_us", control.jitter.value_or(mayfly::Percentiles{}), ", ");
  print("run_us", control.run.value_or(mayfly::Percentiles{}), ", ");
  print("witness_us", executor.witness().oversleep().value_or(mayfly::Percentiles{}), ", \"tasks\": [");
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    print(tasks[i], i + 1 < tasks.size() ? "}, " : "}");
  }
  std::printf("]}}\n");
}

// The right that was granted.
int take_rights(int priority) {
  if (priority <= 0) {
    return 0;
  }
  const mayfly::RealtimeRights rights = mayfly::request_realtime(priority);
  for (const auto& refusal : rights.refused) {
    std::fprintf(stderr, "%s: %s; %s\n", refusal.right.c_str(), refusal.reason.c_str(),
                 refusal.remedy.c_str());
  }
  return rights.priority;
}

}  // namespace

// Arguments: seconds, rate in Hz, SCHED_FIFO priority (0: none), agents, rate of the planner.
int main(int argc, char** argv) {
  const auto argument = [&](int n, double otherwise) {
    return argc > n ? std::strtod(argv[n], nullptr) : otherwise;
  };
  const double seconds = argument(1, 10.0);
  const double rate = argument(2, 100.0);
  const int priority = static_cast<int>(argument(3, 80.0));
  const auto agents = static_cast<std::size_t>(argument(4, 300.0));
  const double planner_rate = argument(5, 50.0);

  mayfly::RealtimeClock clock;
  mayfly::Executor executor(clock);
  mayfly::bench::LoopLoad load(agents, 20.0F, mayfly::from_seconds(1.0 / rate));
  mayfly::bench::LoopLoad planned(agents, 20.0F, mayfly::from_seconds(1.0 / planner_rate));
  const auto tick = [&](const mayfly::TickInfo& info) noexcept {
    load.govern(info.scheduled);
    load.move(static_cast<float>(mayfly::to_seconds(info.period)));
    load.measure();
  };
  const auto plan = [&](const mayfly::TickInfo& info) noexcept { planned.govern(info.scheduled); };
  const auto publish = [](const mayfly::TickInfo&) noexcept {};
  auto added = executor.add_task("control", rate, tick);
  if (added) {
    added = executor.add_planner("planner", planner_rate, mayfly::Time{0}, plan, publish);
  }
  if (!added) {
    std::fprintf(stderr, "%s\n", mayfly::to_string(added.error()).c_str());
    return 2;
  }
  const int granted = take_rights(priority);
  executor.set_realtime({granted, granted > 0 ? mayfly::control_cpu() : -1, true});
  const std::atomic<bool> never{false};
  if (auto ran = executor.run(mayfly::from_seconds(seconds), never); !ran) {
    std::fprintf(stderr, "%s\n", mayfly::to_string(ran.error()).c_str());
    return 3;
  }
  print(executor);
  return 0;
}
