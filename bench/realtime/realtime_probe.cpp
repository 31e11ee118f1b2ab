// The executor at a fixed rate in real time, with a tick's worth of work, as `mayfly run` would use it.
// Prints the `control` part of a summary (docs: the summary file). bench/realtime/compare runs it beside
// cyclictest.
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

}  // namespace

// Arguments: seconds, rate in Hz, SCHED_FIFO priority (0: none), agents.
int main(int argc, char** argv) {
  const auto argument = [&](int n, double otherwise) {
    return argc > n ? std::strtod(argv[n], nullptr) : otherwise;
  };
  const double seconds = argument(1, 10.0);
  const double rate = argument(2, 100.0);
  const int priority = static_cast<int>(argument(3, 80.0));
  const auto agents = static_cast<std::size_t>(argument(4, 300.0));

  mayfly::RealtimeClock clock;
  mayfly::Executor executor(clock);
  mayfly::bench::LoopLoad load(agents, 20.0F, mayfly::from_seconds(1.0 / rate));
  const auto tick = [&](const mayfly::TickInfo& info) noexcept {
    load.govern(info.scheduled);
    load.move(static_cast<float>(mayfly::to_seconds(info.period)));
    load.measure();
  };
  if (auto added = executor.add_task("control", rate, tick); !added) {
    std::fprintf(stderr, "%s\n", mayfly::to_string(added.error()).c_str());
    return 2;
  }
  if (priority > 0) {
    for (const auto& refusal : mayfly::request_realtime(priority).refused) {
      std::fprintf(stderr, "%s: %s; %s\n", refusal.right.c_str(), refusal.reason.c_str(),
                   refusal.remedy.c_str());
    }
  }
  const std::atomic<bool> never{false};
  executor.run(mayfly::from_seconds(seconds), never);

  const mayfly::TaskStats stats = executor.stats().at(0);
  std::printf(
      "{\"control\": {\"rate_hz\": %g, \"ticks\": %llu, \"missed\": %llu, \"missed_by_machine\": %llu, ",
      stats.rate_hz, static_cast<unsigned long long>(stats.ticks),
      static_cast<unsigned long long>(stats.missed),
      static_cast<unsigned long long>(stats.missed_by_machine));
  print("jitter_us", stats.jitter.value_or(mayfly::Percentiles{}), ", ");
  print("run_us", stats.run.value_or(mayfly::Percentiles{}), "}}\n");
  return 0;
}
