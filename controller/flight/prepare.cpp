#include "controller/flight/prepare.hpp"

#include <utility>

#include "controller/flight/placement.hpp"
#include "controller/flight/start_check.hpp"

namespace mayfly {

tl::expected<std::unique_ptr<const Prepared>, std::vector<Error>> prepare(const Scenario& scenario,
                                                                          const PrepareOptions& options) {
  auto world = build_world(scenario, options.threads, options.progress, options.cache);
  if (!world) {
    return tl::unexpected(std::move(world.error()));
  }
  if (options.warn) {
    for (const Error& warning : world->warnings) {
      options.warn(warning);
    }
  }
  auto places = place_agents(scenario, *world);
  if (!places) {
    return tl::unexpected(std::move(places.error()));
  }
  if (auto safe = check_start(scenario, *world, *places); !safe) {
    return tl::unexpected(std::vector{std::move(safe.error())});
  }
  // On the heap before anything points into it.
  auto prepared = std::make_unique<Prepared>(Prepared{std::move(*world), std::move(*places), {}});
  prepared->models = make_swarm_models(scenario, prepared->world, options.in_real_time);
  prepared->world.preprocessing.noise = prepared->models.noise_s;
  return prepared;
}

}  // namespace mayfly
