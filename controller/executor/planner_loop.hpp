// A task in a thread of its own: it may take its time, and control does not wait for it.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "controller/executor/releases.hpp"
#include "core/clock.hpp"

namespace mayfly {

struct PlannerTask {
  Releases releases;
  // From a release to when its result is there, or later, where the work takes longer.
  Time latency{0};
  std::function<void(const TickInfo&)> work;
  std::function<void(const TickInfo&)> publish;
  // On a virtual clock: the release whose result is not there yet, and when it will be.
  std::optional<TickInfo> pending{};
  Time due{0};
};

// What the thread does, on the real clock: works at each release of [0, duration) and publishes once it has
// worked and the latency has passed; late releases are skipped. Returns soon after `ending` is true, between
// two releases.
void serve_planner(PlannerTask& planner, Clock& clock, Time start, Time duration,
                   const std::atomic<bool>& ending) noexcept;

}  // namespace mayfly
