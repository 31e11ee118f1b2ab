// A scenario flown on simulated robots and a virtual clock, in one call: what a test or a planner of
// trajectories wants.
#pragma once

#include <span>
#include <vector>

#include "controller/flight/observer.hpp"
#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly::simulate {

struct Options {
  int threads = 1;                         // of the native engine and the field builders
  std::span<Observer* const> observers{};  // see every tick
};

// The same scenario and seed give the same bits. Errors are those of the world, the places of the agents and
// the HAL.
tl::expected<Summary, std::vector<Error>> fly_simulated(const Scenario& scenario,
                                                        const Options& options = {});

}  // namespace mayfly::simulate
