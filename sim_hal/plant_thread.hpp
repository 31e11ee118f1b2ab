// Real time: a thread of its own owns the plants, and the control loop only meets it at mailboxes.
#pragma once

#include <atomic>
#include <string_view>
#include <thread>

#include "core/clock.hpp"
#include "core/mailbox.hpp"
#include "sim_hal/plant_run.hpp"

namespace mayfly::sim_hal {

class PlantThread {
 public:
  // All three outlive the thread. While it runs, `plants` belongs to it.
  PlantThread(PlantRun& plants, Clock& clock, std::size_t robots, double rate_hz);
  ~PlantThread() { stop(); }
  PlantThread(const PlantThread&) = delete;
  PlantThread& operator=(const PlantThread&) = delete;

  // Publishes a first sample before it returns.
  void start(Time now);
  // Returns when the thread has ended: within a few milliseconds of its clock. Idempotent.
  void stop() noexcept;

  Mailbox<PlantCommand>& commands() noexcept { return commands_; }
  Mailbox<PoseSample>& poses() noexcept { return poses_; }
  bool failed() const noexcept { return failed_.load(std::memory_order_relaxed); }

 private:
  void run(Time next) noexcept;
  void turn() noexcept;

  PlantRun* plants_;
  Clock* clock_;
  Time period_;
  Mailbox<PlantCommand> commands_;
  Mailbox<PoseSample> poses_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> failed_{false};
  std::thread thread_;
};

}  // namespace mayfly::sim_hal
