#include "controller/executor/executor.hpp"

#include <algorithm>
#include <new>
#include <system_error>

#include "controller/clock/realtime_rights.hpp"
#include "core/armed_tick.hpp"

namespace mayfly {

bool Executor::is_taken(const std::string& name) const {
  const auto has_it = [&](const auto& task) { return task.releases.name() == name; };
  return std::any_of(tasks_.begin(), tasks_.end(), has_it) ||
         std::any_of(planners_.begin(), planners_.end(), has_it);
}

Result<void> Executor::add_control(const std::string& name, double rate_hz, Function sense, Function act) {
  auto releases = Releases::make(name, rate_hz);
  if (!releases) {
    return fail(std::move(releases.error()));
  }
  if (is_taken(name)) {
    return fail({.message = "there are two tasks '" + name + "'"});
  }
  tasks_.push_back({std::move(*releases), std::move(sense), std::move(act)});
  return {};
}

Result<void> Executor::add(const std::string& name, double rate_hz, Time latency, Function work,
                           Function publish) {
  auto releases = Releases::make(name, rate_hz);
  if (!releases) {
    return fail(std::move(releases.error()));
  }
  if (is_taken(name)) {
    return fail({.message = "there are two tasks '" + name + "'"});
  }
  if (latency < Time{0} || latency > releases->period()) {
    return fail({.message = "planner '" + name + "' cannot have this latency",
                 .found = std::to_string(to_seconds(latency)) + " s",
                 .wanted = "0 to its period, " + std::to_string(to_seconds(releases->period())) + " s"});
  }
  planners_.push_back({std::move(*releases), latency, std::move(work), std::move(publish)});
  return {};
}

Result<void> Executor::run(Time duration, const std::atomic<bool>& stop) noexcept {
  for (ControlTask& task : tasks_) {
    task.releases.restart();
  }
  for (PlannerTask& planner : planners_) {
    planner.releases.restart();
    planner.pending.reset();
  }
  const Time start = clock_.now();
  const bool is_real = !clock_.is_virtual();
  if (is_real) {
    if (auto started = start_beside(start, duration); !started) {
      end_beside();
      return started;
    }
  }
  // Last, because threads inherit where they may run.
  const std::vector<int> everywhere = is_real && realtime_.cpu >= 0 ? allowed_cpus() : std::vector<int>();
  const bool pinned = !everywhere.empty() && pin_thread(realtime_.cpu);
  run_control(start, duration, stop);
  if (pinned) {
    allow_cpus(everywhere);
  }
  end_beside();
  return {};
}

Result<void> Executor::start_beside(Time start, Time duration) try {
  ending_ = false;
  for (PlannerTask& planner : planners_) {
    threads_.emplace_back(
        [this, &planner, start, duration] { serve_planner(planner, clock_, start, duration, ending_); });
  }
  if (!realtime_.witness || tasks_.empty()) {
    return {};
  }
  const auto fastest = std::min_element(tasks_.begin(), tasks_.end(), [](const auto& a, const auto& b) {
    return a.releases.period() < b.releases.period();
  });
  return witness_.start(clock_, start, fastest->releases.period(), {realtime_.priority, realtime_.cpu});
} catch (const std::system_error& error) {
  return fail(Cause::kEnvironment, std::string("no thread for a planner: ") + error.what());
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment, "there is not enough memory for a planner's thread");
}

void Executor::end_beside() noexcept {
  ending_ = true;
  for (std::thread& thread : threads_) {
    thread.join();
  }
  threads_.clear();
  witness_.stop();
}

void Executor::run_control(Time start, Time duration, const std::atomic<bool>& stop) noexcept {
  sleep_ = {};
  while (!stop.load(std::memory_order_relaxed)) {
    const Time now = clock_.now() - start;
    for (ControlTask& task : tasks_) {
      task.releases.skip_expired(now, duration, sleep_);
    }
    if (publish_pending(now)) {
      continue;
    }
    if (ControlTask* task = earliest_due(now, duration)) {
      run_task(*task, start, now, duration);
      continue;
    }
    if (run_planners(start, now, duration)) {
      continue;
    }
    const Time wake = next_event(duration);
    if (wake == duration && now >= duration) {
      return;
    }
    clock_.sleep_until(start + wake);
    sleep_ = {now, clock_.now() - start};
  }
}

Executor::ControlTask* Executor::earliest_due(Time now, Time duration) noexcept {
  ControlTask* earliest = nullptr;
  for (ControlTask& task : tasks_) {
    if (task.releases.is_due(now, duration) &&
        (earliest == nullptr || task.releases.deadline() < earliest->releases.deadline())) {
      earliest = &task;
    }
  }
  return earliest;
}

Time Executor::next_event(Time duration) const noexcept {
  Time next = duration;
  for (const ControlTask& task : tasks_) {
    next = std::min(next, task.releases.scheduled());
  }
  if (!clock_.is_virtual()) {
    return next;
  }
  for (const PlannerTask& planner : planners_) {
    next = std::min(next, planner.releases.scheduled());
    if (planner.pending) {
      next = std::min(next, planner.due);
    }
  }
  return next;
}

void Executor::run_task(ControlTask& task, Time start, Time now, Time duration) noexcept {
  const TickInfo info = task.releases.begin(start, now);
  working_.begin(info.started);
  Time worked = Time{0};
  const auto half = [&](const Function& function) {
    const Time began = real_now();
    const ArmedTick armed;
    function(info);
    worked += real_now() - began;
  };
  if (task.sense) {
    half(task.sense);
    run_planners(start, now, duration);
  }
  half(task.act);
  const Time ended = clock_.now();
  working_.end(ended);
  task.releases.end(now, ended - start, worked, sleep_);
}

// On a virtual clock only: otherwise planners publish for themselves.
bool Executor::publish_pending(Time now) noexcept {
  bool any = false;
  for (PlannerTask& planner : planners_) {
    if (planner.pending && planner.due <= now) {
      planner.publish(*planner.pending);
      planner.pending.reset();
      any = true;
    }
  }
  return any;
}

bool Executor::run_planners(Time start, Time now, Time duration) noexcept {
  if (!clock_.is_virtual()) {
    return false;
  }
  bool any = false;
  for (PlannerTask& planner : planners_) {
    planner.releases.skip_expired(now, duration, sleep_);
    if (!planner.releases.is_due(now, duration)) {
      continue;
    }
    const TickInfo info = planner.releases.begin(start, now);
    const Time began = real_now();
    planner.work(info);
    any = true;
    if (planner.latency > Time{0}) {
      planner.due = planner.releases.scheduled() + planner.latency;
      planner.pending = info;
    } else {
      planner.publish(info);
    }
    planner.releases.end(now, clock_.now() - start, real_now() - began, sleep_);
  }
  return any;
}

std::vector<TaskStats> Executor::stats() const {
  std::vector<TaskStats> all;
  all.reserve(tasks_.size() + planners_.size());
  for (const ControlTask& task : tasks_) {
    all.push_back(task.releases.stats());
  }
  for (const PlannerTask& planner : planners_) {
    all.push_back(planner.releases.stats());
    all.back().own_thread = true;
  }
  return all;
}

}  // namespace mayfly
