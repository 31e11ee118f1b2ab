#include "controller/flight/flight.hpp"

#include <algorithm>
#include <memory>
#include <thread>
#include <utility>

#include "controller/executor/executor.hpp"
#include "controller/flight/field_keeper.hpp"
#include "controller/flight/flight_config.hpp"
#include "controller/flight/flight_loop.hpp"

namespace mayfly {
namespace {

// In real time one processor is left to the control loop.
int solver_threads(bool is_virtual) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return is_virtual ? cores : std::max(1, cores - 1);
}

}  // namespace

Result<Summary> fly(const FlightParts& parts) {
  Motion motion(parts.scenario);
  auto governor = Governor::make(governor_config(parts.scenario, parts.world, motion));
  if (!governor) {
    return fail(std::move(governor.error()));
  }
  if (auto configured = parts.hal.configure(); !configured) {
    return fail(std::move(configured.error()));
  }
  if (parts.hal.robots().size() != governor->agents()) {
    return fail(Cause::kDevice, "the HAL has " + std::to_string(parts.hal.robots().size()) +
                                    " robots, the scenario " + std::to_string(governor->agents()) +
                                    " agents");
  }
  std::unique_ptr<FieldKeeper> keeper;
  if (parts.world.solver != nullptr) {
    auto started = FieldKeeper::start(parts.scenario, *parts.world.solver,
                                      {parts.clock.is_virtual(), solver_threads(parts.clock.is_virtual())});
    if (!started) {
      return fail(std::move(started.error()));
    }
    keeper = std::move(*started);
  }
  FlightLoop flight(parts, motion, keeper.get(), std::move(*governor),
                    Metrics(metrics_config(parts.scenario, parts.world, motion)));
  Executor executor(parts.clock);
  auto added = executor.add_task("control", static_cast<double>(parts.scenario.control.rate),
                                 [&flight](const TickInfo&) noexcept { flight.tick(); });
  if (!added) {
    return fail(std::move(added.error()));
  }
  const auto start = std::chrono::steady_clock::now();
  if (auto activated = parts.hal.activate(parts.clock.now()); !activated) {
    return fail(std::move(activated.error()));
  }
  executor.run(from_seconds(parts.scenario.duration), flight.finished());
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  auto deactivated = parts.hal.deactivate(parts.clock.now());
  if (!deactivated) {
    return fail(std::move(deactivated.error()));
  }
  return flight.summarise(executor, wall_s);
}

}  // namespace mayfly
