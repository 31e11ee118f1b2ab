#include "simulate/fly_simulated.hpp"

#include <utility>

#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/placement.hpp"
#include "controller/flight/swarm_models.hpp"
#include "simulate/robots.hpp"

namespace mayfly::simulate {

tl::expected<Summary, std::vector<Error>> fly_simulated(const Scenario& scenario, const Options& options) {
  auto world = build_world(scenario, options.threads, {});
  if (!world) {
    return tl::unexpected(std::move(world.error()));
  }
  const auto places = place_agents(scenario, *world);
  if (!places) {
    return tl::unexpected(places.error());
  }
  const SwarmModels models = make_swarm_models(scenario, *world);
  world->preprocessing.noise = models.noise_s;
  const auto engine = make_native_engine(options.threads);
  if (auto prepared = engine->prepare(models.swarms, models.agents()); !prepared) {
    return tl::unexpected(std::vector<Error>{std::move(prepared.error())});
  }
  VirtualClock clock;
  const Robots robots = make_robots(scenario, *places, clock);
  auto flown = fly({.scenario = scenario,
                    .world = *world,
                    .engine = *engine,
                    .hal = *robots.hal,
                    .truth = robots.truth.get(),
                    .clock = clock,
                    .observers = options.observers});
  if (!flown) {
    return tl::unexpected(std::vector<Error>{std::move(flown.error())});
  }
  return *flown;
}

}  // namespace mayfly::simulate
