// What a swarm's paths cost it, in the terms of the fields.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "fields/cost_field.hpp"
#include "fields/cost_terms.hpp"

namespace mayfly {

fields::CostParams cost_params(const SwarmSpec& swarm);

// The brushes that change what ways cost it, in the scenario's order.
std::vector<fields::CostBrush> cost_brushes(const Scenario& scenario, const SwarmSpec& swarm);

// Those who do fly by the same cost field.
bool share_cost(const Scenario& scenario, const SwarmSpec& a, const SwarmSpec& b);

// Of the scenario's goals, the one the swarm flies to; how many there are, for one without a goal.
std::size_t goal_index(const Scenario& scenario, const SwarmSpec& swarm);

// Whether its fields have to be solved again in flight: its goal or an obstacle moves, or density counts.
bool changes_in_flight(const Scenario& scenario, const SwarmSpec& swarm);

}  // namespace mayfly
