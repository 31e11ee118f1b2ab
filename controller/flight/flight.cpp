#include "controller/flight/flight.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "controller/executor/executor.hpp"
#include "controller/flight/field_keeper.hpp"
#include "controller/flight/flight_config.hpp"
#include "controller/flight/flight_guard.hpp"
#include "controller/flight/flight_loop.hpp"
#include "controller/flight/flight_rights.hpp"
#include "controller/flight/timing_summary.hpp"
#include "controller/guard/guarded_hal.hpp"
#include "controller/planner/curl_noise_planner.hpp"

namespace mayfly {
namespace {

// In real time one processor is left to the control loop.
int solver_threads(bool is_virtual) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return is_virtual ? cores : std::max(1, cores - 1);
}

// None on the virtual clock, which needs none.
Result<std::optional<FlightRights>> take_rights(const FlightParts& parts) {
  if (parts.clock.is_virtual()) {
    return std::optional<FlightRights>();
  }
  auto rights = FlightRights::take(parts.scenario.control.realtime);
  if (!rights) {
    return fail(std::move(rights.error()));
  }
  return std::optional<FlightRights>(std::move(*rights));
}

Result<void> add_tasks(Executor& executor, const Scenario& scenario, FlightLoop& flight, Planner* beside) {
  auto added = executor.add_task(
      "control", static_cast<double>(scenario.control.rate),
      [&flight](const TickInfo&) noexcept { flight.sense(); },
      [&flight](const TickInfo&) noexcept { flight.act(); });
  if (!added || beside == nullptr) {
    return added;
  }
  const PlannerSpec& spec = *curl_noise_of(scenario);
  return executor.add_planner(
      spec.name, static_cast<double>(spec.rate), latency_of(spec),
      [beside](const TickInfo& info) noexcept { beside->work(info.release, info.started); },
      [beside](const TickInfo&) noexcept { beside->publish(); });
}

}  // namespace

Result<Summary> fly(const FlightParts& parts) {
  Motion motion(parts.scenario);
  std::optional<GuardedHal> own_guard;
  if (parts.guard == nullptr) {
    GuardConfig config = guard_config(parts.scenario, parts.world, motion, parts.clock);
    config.exchange = parts.exchange;
    own_guard.emplace(std::move(config), parts.hal);
  }
  GuardPort& nearest = parts.guard == nullptr ? *own_guard : *parts.guard;
  const std::unique_ptr<GuardPort> between = parts.between ? parts.between(nearest) : nullptr;
  GuardPort& guard = between ? *between : nearest;
  if (auto configured = guard.configure(); !configured) {
    return fail(std::move(configured.error()));
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
  FieldPlanner planner(parts.scenario, parts.engine, keeper.get(), plan_timing(parts.scenario));
  std::optional<CurlNoisePlanner> beside;
  if (curl_noise_of(parts.scenario) != nullptr) {
    beside.emplace(parts.scenario, planner);
  }
  FlightLoop flight(parts, motion, planner, beside ? &*beside : nullptr, guard,
                    Metrics(metrics_config(parts.scenario, parts.world, motion)));
  auto rights = take_rights(parts);
  if (!rights) {
    return fail(std::move(rights.error()));
  }
  Executor executor(parts.clock);
  if (*rights) {
    const int priority = (*rights)->granted().priority;
    executor.set_realtime({priority, priority > 0 ? control_cpu() : -1, true});
  }
  if (auto added = add_tasks(executor, parts.scenario, flight, beside ? &*beside : nullptr); !added) {
    return fail(std::move(added.error()));
  }
  const auto start = std::chrono::steady_clock::now();
  if (auto activated = guard.activate(parts.clock.now()); !activated) {
    return fail(std::move(activated.error()));
  }
  const auto flown = executor.run(from_seconds(parts.scenario.duration), flight.finished());
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  auto deactivated = guard.deactivate(parts.clock.now());
  if (!deactivated) {
    return fail(std::move(deactivated.error()));
  }
  if (!flown) {
    return fail(flown.error());
  }
  if (const BlackBoxTape* tape = guard.tape(); tape != nullptr && parts.keep_tape) {
    parts.keep_tape(*tape);
  }
  std::vector<AgeStats> ages;
  if (beside) {
    ages = {beside->estimate_ages(), beside->plan_ages()};
  }
  return flight.summarise(control_summary(executor, *rights ? &**rights : nullptr, ages), wall_s);
}

}  // namespace mayfly
