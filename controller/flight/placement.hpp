// Where agents start.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/flight/world.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// One position an agent, swarm after swarm in the scenario's order: uniform in each swarm's start region,
// outside obstacles by the body's radius, able to reach the goal it is led to, at least `separation` apart;
// governed ones also as far from obstacles and each other as the governor keeps them, at rest.
// The same seed gives the same places. Errors name the start region: it lies inside an obstacle, or the
// agents do not fit.
tl::expected<std::vector<glm::vec3>, std::vector<Error>> place_agents(const Scenario& scenario,
                                                                      const World& world);

}  // namespace mayfly
