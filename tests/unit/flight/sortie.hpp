// All that one flight needs, put together from a scenario.
#pragma once

#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/placement.hpp"
#include "controller/flight/swarm_models.hpp"
#include "tests/unit/flight/point_hal.hpp"

namespace mayfly::test {

inline std::vector<glm::vec3> start_places(const Scenario& scenario, const World& world) {
  auto places = place_agents(scenario, world);
  if (!places) {
    ADD_FAILURE() << all_text(places.error());
    std::abort();
  }
  return std::move(*places);
}

struct Sortie {
  explicit Sortie(Scenario flown)
      : scenario(std::move(flown)),
        world(world_of(scenario)),
        models(make_swarm_models(scenario, world)),
        engine(make_native_engine(1)),
        hal(start_places(scenario, world)) {
    if (auto ready = engine->prepare(models.swarms, models.agents()); !ready) {
      ADD_FAILURE() << to_string(ready.error());
    }
  }

  Result<Summary> fly() { return fly_with(hal, *engine); }
  Result<Summary> fly_with(Hal& robots, Engine& decides) {
    return mayfly::fly({.scenario = scenario,
                        .world = world,
                        .engine = decides,
                        .hal = robots,
                        .clock = clock,
                        .observers = observers,
                        .stop = &stop,
                        .gauge = &gauge});
  }

  Scenario scenario;
  World world;
  SwarmModels models;
  std::unique_ptr<Engine> engine;
  PointHal hal;
  VirtualClock clock;
  std::vector<Observer*> observers;
  StopRequest stop{0};
  FlightGauge gauge;
};

}  // namespace mayfly::test
