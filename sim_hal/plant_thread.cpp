#include "sim_hal/plant_thread.hpp"

#include <algorithm>

namespace mayfly::sim_hal {

namespace {

// A launch costs up to a millisecond on a loaded machine, so faster plants are stepped several at a time.
constexpr Time kShortestPeriod = std::chrono::milliseconds(2);

}  // namespace

PlantThread::PlantThread(PlantRun& plants, Clock& clock, std::size_t robots, double rate_hz)
    : plants_(&plants),
      clock_(&clock),
      period_(std::max(kShortestPeriod, from_seconds(1.0 / rate_hz))),
      commands_(PlantCommand(robots)),
      poses_(PoseSample(robots)) {}

void PlantThread::start(Time now) {
  commands_.collect();  // what is left from before the last stop is not for now
  stopping_ = false;
  poses_.draft().copy(plants_->view());
  poses_.publish();
  thread_ = std::thread([this, now] { run(now + period_); });
}

void PlantThread::stop() noexcept {
  stopping_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void PlantThread::run(Time next) noexcept {
  while (!stopping_) {
    clock_->sleep_until(next);
    turn();
    next = std::max(next, clock_->now() - period_) +
           period_;  // late turns are skipped, never caught up in a burst
  }
}

void PlantThread::turn() noexcept {
  const std::string_view failure = plants_->advance(clock_->now());
  if (!failure.empty()) {
    failed_ = true;
    return;
  }
  if (commands_.collect()) {
    plants_->command(commands_.latest());
  }
  poses_.draft().copy(plants_->view());
  poses_.publish();
}

}  // namespace mayfly::sim_hal
