// A scenario's world on a nested grid. For world.cpp only.
#pragma once

#include <span>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "core/progress.hpp"
#include "core/result.hpp"
#include "fields/nested_distance.hpp"

namespace mayfly {

// What a scenario with a coarse cell asks for and this version does not do: what changes in flight, brushes
// that change costs, and a coarse cell other than NestedGrid::kRatio cells.
std::vector<Error> nested_refusals(const Scenario& scenario);

// With bricks as far as any swarm feels an obstacle.
Result<fields::NestedDistance> make_nested_distance(const Scenario& scenario, const fields::Geometry& solid,
                                                    std::span<const fields::Geometry> goals, int threads,
                                                    const Progress& progress);

}  // namespace mayfly
