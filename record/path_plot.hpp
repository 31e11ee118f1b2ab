// The picture of a flight.
#pragma once

#include <string>

#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"
#include "record/path_sampler.hpp"

namespace mayfly::record {

// A PNG, 1600 px wide: the world from above and from the side, at one scale, obstacles in grey, start and
// goals outlined, paths coloured by time, key figures in words.
Result<std::string> draw_path_plot(const Scenario& scenario, const Summary& summary,
                                   const PathSampler& paths);

}  // namespace mayfly::record
