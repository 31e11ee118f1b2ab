#include "controller/executor/planner_loop.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// A run's end is seen this often, however rarely the planner works.
constexpr Time kNap = std::chrono::milliseconds(10);

}  // namespace

void serve_planner(PlannerTask& planner, Clock& clock, Time start, Time duration,
                   const std::atomic<bool>& ending) noexcept {
  Releases& releases = planner.releases;
  Sleep sleep;
  bool slept = false;
  while (!ending.load(std::memory_order_relaxed)) {
    const Time now = clock.now() - start;
    releases.skip_expired(now, duration, sleep);
    if (releases.scheduled() >= duration) {
      return;
    }
    if (releases.is_due(now, duration)) {
      const TickInfo info = releases.begin(start, now);
      const Time began = real_now();
      planner.work(info);
      planner.publish(info);
      releases.end(now, clock.now() - start, real_now() - began, sleep);
      slept = false;
      continue;
    }
    clock.sleep_until(start + std::min(releases.scheduled(), now + kNap));
    sleep = {slept ? sleep.began : now, clock.now() - start};
    slept = true;
  }
}

}  // namespace mayfly
