// Where agents come to rest: each has a place of its own in its goal, so that a swarm fills the goal instead
// of piling up.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/flight/world.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// One place an agent of swarm `index`: uniform over the free part of its goal, at its separation from the
// others where the goal has room for that. In a goal smaller than a cell all share the place that is cheapest
// to reach.
std::vector<glm::vec3> rest_places(const Scenario& scenario, const World& world, std::uint32_t index);

}  // namespace mayfly
