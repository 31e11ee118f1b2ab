// What rounding may take from a distance; docs/explanation/safety.md derives each, and tests hold them.
#pragma once

#include "controller/governor/governor_config.hpp"

namespace mayfly {

// m: by how much a place that arrives as three floats of at most `extent` m may be off, twice for the
// plant's own rounding and twice because references are not moved for less.
double pose_rounding(double extent) noexcept;

// m: commands are floats, so a robot that brakes may leave what it had reserved. The sum over all ticks from
// the speed limit to rest.
double braking_rounding(const GovernorLimits& limits, double period) noexcept;

// m: of capsules and their distance, computed in double with places of at most `extent` m.
double geometry_rounding(double extent) noexcept;

// m: between the arc of a tick and its chord, a_max·T²/8.
double arc_height(const GovernorLimits& limits, double period) noexcept;

}  // namespace mayfly
