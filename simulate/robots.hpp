// The simulated robots of a scenario.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "controller/flight/flight.hpp"
#include "controller/guard/exchange.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/clock.hpp"
#include "core/hal.hpp"
#include "sim_hal/config.hpp"

namespace mayfly::simulate {

struct Robots {
  std::unique_ptr<Hal> hal;
  std::unique_ptr<Exchange> exchange;  // none where nobody is taken out; after `hal`, which it needs
  std::unique_ptr<GroundTruth> truth;  // none on the real clock: then the simulation has a life of its own
};

// One robot an agent, in the scenario's order, starting at `places` (m), with what the scenario lets go wrong
// with robots and their links. `clock` must outlive the HAL, and so must `watcher`, which sees the plant
// steps of every HAL; without one the truth counts breaches itself where the scenario expects something of
// them.
Robots make_robots(const Scenario& scenario, const std::vector<glm::vec3>& places, Clock& clock,
                   sim_hal::Backend backend = sim_hal::Backend::kAutomatic,
                   sim_hal::StepWatcher* watcher = nullptr);

// What the robots that make_robots() makes are called, before there are any.
std::vector<RobotInfo> robot_names(const Scenario& scenario);

}  // namespace mayfly::simulate
