// Whether a flight may begin where its agents are placed.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "controller/flight/world.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Refuses what the governor cannot promise anything of (Governor::make, Governor::admit): limits that
// contradict each other or the fence, and governed agents that start outside the safe set; with the
// inequality, its numbers and the agents' names. `places`: m, one an agent, all at rest. Robots that a
// scenario's faults put elsewhere are not asked for: it wants to see what becomes of them.
Result<void> check_start(const Scenario& scenario, const World& world, std::span<const glm::vec3> places);

}  // namespace mayfly
