#include "controller/executor/executor.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

constexpr double kLowestRate = 1e-3;  // Hz
constexpr double kHighestRate = 1e5;  // Hz

// The work's own duration, also where the run's clock stands still.
Time real_now() noexcept {
  return std::chrono::steady_clock::now().time_since_epoch();
}

}  // namespace

Result<void> Executor::add(std::string name, double rate_hz, std::function<void(const TickInfo&)> function) {
  if (!(rate_hz >= kLowestRate && rate_hz <= kHighestRate)) {
    return fail({.message = "a task '" + name + "' cannot run at this rate",
                 .found = std::to_string(rate_hz) + " Hz",
                 .wanted = "0.001 to 100000 Hz"});
  }
  if (std::any_of(tasks_.begin(), tasks_.end(), [&](const Task& task) { return task.name == name; })) {
    return fail({.message = "there are two tasks '" + name + "'"});
  }
  Task task;
  task.name = std::move(name);
  task.rate_hz = rate_hz;
  task.period = Time(std::llround(1e9 / rate_hz));
  task.function = std::move(function);
  tasks_.push_back(std::move(task));
  return {};
}

void Executor::run(Time duration, const std::atomic<bool>& stop) noexcept {
  for (Task& task : tasks_) {
    task.next = 0;
    task.skipped_before_next = 0;
  }
  const Time start = clock_.now();
  sleep_ = {};
  while (!stop.load(std::memory_order_relaxed)) {
    const Time now = clock_.now() - start;
    for (Task& task : tasks_) {
      skip_expired(task, now, duration);
    }
    if (Task* task = earliest_due(now, duration)) {
      run_task(*task, start, now);
      continue;
    }
    const Time wake = next_release(duration);
    if (wake == duration && now >= duration) {
      return;
    }
    clock_.sleep_until(start + wake);
    sleep_ = {now, clock_.now() - start};
  }
}

// A release is lost once its deadline has passed before it could start. It is the machine's where we had gone
// to sleep before the release and were not woken until after the deadline; else other work of ours stood in
// the way.
void Executor::skip_expired(Task& task, Time now, Time duration) noexcept {
  while (task.scheduled() < duration && task.deadline() <= now) {
    const bool overslept = task.scheduled() >= sleep_.began && task.deadline() <= sleep_.ended;
    ++task.missed;
    ++task.skipped;
    task.missed_by_machine += overslept ? 1U : 0U;
    ++task.skipped_before_next;
    ++task.next;
  }
}

Executor::Task* Executor::earliest_due(Time now, Time duration) noexcept {
  Task* earliest = nullptr;
  for (Task& task : tasks_) {
    const bool due = task.scheduled() <= now && task.scheduled() < duration;
    if (due && (earliest == nullptr || task.deadline() < earliest->deadline())) {
      earliest = &task;
    }
  }
  return earliest;
}

Time Executor::next_release(Time duration) const noexcept {
  Time next = duration;
  for (const Task& task : tasks_) {
    next = std::min(next, task.scheduled());
  }
  return next;
}

void Executor::run_task(Task& task, Time start, Time now) noexcept {
  const TickInfo info{task.next, task.skipped_before_next, start + task.scheduled(), start + now,
                      task.period};
  const Time began = real_now();
  task.function(info);
  task.run.record(real_now() - began);
  task.jitter.record(now - task.scheduled());
  ++task.ticks;
  count_if_late(task, clock_.now() - start);
  task.skipped_before_next = 0;
  ++task.next;
}

// Work that ended after its deadline would have been in time, had the thread been woken when it asked to be:
// then the miss is the machine's.
void Executor::count_if_late(Task& task, Time ended) noexcept {
  if (ended <= task.deadline()) {
    return;
  }
  const bool slept_in_time = task.scheduled() >= sleep_.began && task.scheduled() <= sleep_.ended;
  const Time overslept = slept_in_time ? sleep_.ended - task.scheduled() : Time{0};
  ++task.missed;
  task.missed_by_machine += ended - overslept <= task.deadline() ? 1U : 0U;
}

std::vector<TaskStats> Executor::stats() const {
  std::vector<TaskStats> all;
  all.reserve(tasks_.size());
  for (const Task& task : tasks_) {
    all.push_back({task.name, task.rate_hz, task.ticks, task.missed, task.missed_by_machine, task.skipped,
                   task.jitter.percentiles(), task.run.percentiles()});
  }
  return all;
}

}  // namespace mayfly
