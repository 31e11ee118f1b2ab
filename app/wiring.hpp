// From a scenario to the parts that fly it: the only place that names them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/arguments.hpp"
#include "controller/engine/engine.hpp"
#include "controller/flight/prepare.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/clock.hpp"

namespace mayfly::app {

// Every swarm flies on the HAL called `name`; fails if the scenario has none of that name.
Result<void> choose_hal(Scenario& scenario, const std::string& name);

std::unique_ptr<Clock> make_clock(bool fast);

// Ready to compute what was prepared, which must outlive it. `auto` tries both engines on the swarm's first
// places.
Result<std::unique_ptr<Engine>> make_engine(EngineChoice choice, int threads, const Prepared& ready,
                                            float period_s);

}  // namespace mayfly::app
