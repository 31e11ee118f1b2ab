// The native engine's own way to run kernels/orca.h.
#pragma once

#include <cstddef>
#include <span>

#include "controller/engine/avoidance.hpp"

namespace mayfly {

// Replaces the preferred velocities in `velocity` (the agents' order) by ones clear of others, for all swarms
// that avoid collisions. Returns how many agents had none.
std::size_t avoid_collisions(const Avoidance& seen, std::span<const SwarmModel> swarms, float period_s,
                             const VelocityColumns& velocity, ThreadTeam& team) noexcept;

}  // namespace mayfly
