// The twins of a scenario's robots.
#pragma once

#include "controller/scenario/scenario.hpp"
#include "simulate/robots.hpp"

namespace mayfly::simulate {

// Where the scenario takes robots out of the run: puts twins before `robots.hal`, and into the truth, that
// of a robot's twin in the place of the robot's own.
void add_twins(const Scenario& scenario, Robots& robots);

}  // namespace mayfly::simulate
