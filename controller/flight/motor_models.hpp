// What a scenario says of forces, boids, chance and avoidance, as an engine takes it.
#pragma once

#include "controller/engine/engine.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// m/s: what agents of the swarm mostly fly at, before noise.
float typical_speed(const SwarmSpec& swarm);

// Fills in what drives the swarm, and what it feels.
void set_motor(const Scenario& scenario, const SwarmSpec& swarm, SwarmModel& model);

// `margin`, m: by how much two robots may come nearer than the points that are steered; each body is larger
// by half of it. `most_speed`, m/s: nobody is led faster.
kernels::MfAvoidance kernel_avoidance(const SwarmSpec& swarm, float margin, float most_speed);

}  // namespace mayfly
