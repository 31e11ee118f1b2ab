// From a scenario to all that is known before it flies.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "controller/flight/swarm_models.hpp"
#include "controller/flight/world.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/progress.hpp"

namespace mayfly {

struct Prepared {
  World world;
  std::vector<glm::vec3> places;  // m, one an agent: where it starts
  SwarmModels models;             // spans point into `world`
};

struct PrepareOptions {
  int threads = 0;            // of the field builders; 0 for all cores
  bool in_real_time = false;  // robots then keep more from each other (realtime_latency)
  Progress progress{};
  fields::FieldCache cache{};  // of distances and costs
  // What is odd but flies, as soon as it is known: also where an error follows.
  std::function<void(const Error&)> warn{};
};

// Builds the fields, places the agents, sets the models up. Errors are those of build_world,
// place_agents and check_start.
tl::expected<std::unique_ptr<const Prepared>, std::vector<Error>> prepare(const Scenario& scenario,
                                                                          const PrepareOptions& options);

}  // namespace mayfly
