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
  // Sleeps until then, in naps; false where the run ended first.
  const auto sleep_until = [&](Time then) noexcept {
    const Time asked = clock.now() - start;
    for (Time now = asked; now < then; now = clock.now() - start) {
      if (ending.load(std::memory_order_relaxed)) {
        return false;
      }
      clock.sleep_until(start + std::min(then, now + kNap));
      sleep = {asked, clock.now() - start};
    }
    return !ending.load(std::memory_order_relaxed);
  };
  while (sleep_until(std::min(releases.scheduled(), duration))) {
    const Time now = clock.now() - start;
    releases.skip_expired(now, duration, sleep);
    if (releases.scheduled() >= duration) {
      return;
    }
    if (!releases.is_due(now, duration)) {
      continue;
    }
    const TickInfo info = releases.begin(start, now);
    const Time ready = releases.scheduled() + planner.latency;
    const Time began = real_now();
    planner.work(info);
    releases.end(now, clock.now() - start, real_now() - began, sleep);
    if (sleep_until(ready)) {
      planner.publish(info);
    }
  }
}

}  // namespace mayfly
