// What a scenario says of noise, lamps and potential brushes, as the kernels take it.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"
#include "kernels/field.h"

namespace mayfly {

// Swarms with other seeds have other noise. White and Gaussian noise are as fast in the rms as the curl of
// the same octaves would be.
kernels::MfNoise kernel_noise(const NoiseSpec& spec, std::uint32_t seed);

// The lamps, and then the potential brushes, that are meant for `swarm`: none, where no field leads it.
void add_pulls(const Scenario& scenario, const SwarmSpec& swarm, kernels::MfField& field);

// A swarm follows no more than MF_MAX_PULLS of them: an error for each that has more.
std::vector<Error> excess_pulls(const Scenario& scenario);

}  // namespace mayfly
