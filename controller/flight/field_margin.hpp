// By how much the walls of a set of fields must be larger than an obstacle that moves.
#pragma once

#include <vector>

#include "controller/scenario/scenario.hpp"
#include "core/grid.hpp"

namespace mayfly {

// s between two sets of fields: the scenario's rate, and no less than a control period.
double field_period(const Scenario& scenario);

// s that a set is flown by at the most: a control tick longer than the period where that is no multiple of
// the tick.
double set_duration(const Scenario& scenario);

// m, for an obstacle in a set that is flown by from `from_s` to `until_s`; 0 where it has come to its end.
//
// The set has it where it is in the middle of that time: v/2 · (until − from) covers the way to both ends.
// The rest is for agents in its way. A wall's guard leads an agent out at r times its depth in the wall
// (approach_rate): if the wall comes on by v·P at each swap of a period P, an agent is never deeper than v/r
// in it by the end of a period, because a deeper one would leave by more than v·P. Right after a swap it is
// v·P deeper; half of that more keeps it nearer to the front of the wall than to its back, however thin the
// obstacle. Robots that lag by τ behind their command are v·τ deeper, and those that accelerate at a, v²/2a.
float obstacle_margin(const Scenario& scenario, const PathSpec& path, double from_s, double until_s);

// m: all the lengths up to which somebody wants to know how far a wall is.
std::vector<float> wall_lengths(const Scenario& scenario, const Grid& grid);

}  // namespace mayfly
