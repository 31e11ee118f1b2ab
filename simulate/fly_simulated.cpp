#include "simulate/fly_simulated.hpp"

#include <utility>

#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/prepare.hpp"
#include "simulate/robots.hpp"
#include "simulate/sabotage.hpp"

namespace mayfly::simulate {

tl::expected<Summary, std::vector<Error>> fly_simulated(const Scenario& scenario, const Options& options) {
  const auto all = prepare(scenario, {.threads = options.threads});
  if (!all) {
    return tl::unexpected(all.error());
  }
  const Prepared& ready = **all;
  const auto engine = make_native_engine(options.threads);
  if (auto prepared = engine->prepare(ready.models.swarms, ready.models.agents()); !prepared) {
    return tl::unexpected(std::vector<Error>{std::move(prepared.error())});
  }
  VirtualClock clock;
  const Robots robots = make_robots(scenario, ready.places, clock, sim_hal::Backend::kNative);
  const Sabotage sabotage(scenario, *engine, clock, nullptr);
  auto flown = fly({.scenario = scenario,
                    .world = ready.world,
                    .engine = sabotage.engine(),
                    .hal = *robots.hal,
                    .truth = robots.truth.get(),
                    .clock = sabotage.clock(),
                    .observers = options.observers,
                    .stop = sabotage.stop(),
                    .between = [&](GuardPort& guard) { return sabotage.before(guard); },
                    .exchange = robots.exchange.get()});
  if (!flown) {
    return tl::unexpected(std::vector<Error>{std::move(flown.error())});
  }
  return *flown;
}

}  // namespace mayfly::simulate
