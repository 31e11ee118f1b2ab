// What a scenario expects of its own flight, held against what was measured.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// The share of a swarm's agents (all swarms: empty name) that entered a goal; empty where that was not
// measured.
using ReachedFraction = std::function<std::optional<double>(const std::string& swarm)>;

// `asked`: what was measured only because an expectation asks for it, one element an expectation (swarms'
// motion, wall clearance); empty: nothing was.
std::vector<ExpectationResult> hold_expectations(const std::vector<Expectation>& expectations,
                                                 const Summary& summary, const ReachedFraction& reached,
                                                 std::span<const std::optional<double>> asked = {});

}  // namespace mayfly
