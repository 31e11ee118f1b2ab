// The planner's side of a flight in two processes: starts the guard, watches it, and knows how it ended.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/arguments.hpp"
#include "controller/clock/realtime_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/link/process_watch.hpp"
#include "controller/link/shm_hal.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly::app {

class GuardProcess {
 public:
  // Starts this same program again as `mayfly guard`, which loads what is loaded here; the HAL's configure()
  // waits for it. `asked_to_stop` outlives it.
  static Result<std::unique_ptr<GuardProcess>> start(const RunOptions& options, const Scenario& scenario,
                                                     const RealtimeClock& clock,
                                                     const StopRequest& asked_to_stop);
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;
  // The guard ends by itself once nobody leads it: it is never killed from here, for it has robots to bring
  // down.
  ~GuardProcess();

  GuardPort& port() noexcept { return hal_; }
  // The user's request, or the end at once where the guard is lost.
  const StopRequest& stop() const noexcept { return hal_.stop(); }
  // What became of it; empty where it has ended well. After the flight; waits for it a little.
  std::string how_it_failed();

 private:
  GuardProcess(link::ShmHalConfig config, link::PlannerEnd end, link::ProcessWatch watch, pid_t process);
  void watch() noexcept;

  link::ProcessWatch process_watch_;
  pid_t process_;
  link::ShmHal hal_;
  std::atomic<bool> leaving_{false};
  std::thread watcher_;
};

}  // namespace mayfly::app
