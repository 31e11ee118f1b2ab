// What a flight's governor and metrics are told of the scenario and its world.
#pragma once

#include "controller/flight/motion.hpp"
#include "controller/flight/world.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/metrics/metrics.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// An older state is not flown by.
Time most_state_age(const Scenario& scenario);

// Both ask the world for exact distances where its sampled field cannot decide, and see goals and obstacles
// where `motion` has them: world and motion must outlive them.
GovernorConfig governor_config(const Scenario& scenario, const World& world, const Motion& motion);
MetricsConfig metrics_config(const Scenario& scenario, const World& world, const Motion& motion);

}  // namespace mayfly
