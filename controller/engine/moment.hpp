// What a kernel is told of a tick, made on the host.
#pragma once

#include <cstdint>

#include "kernels/noise.h"

namespace mayfly {

// For the tick of this number, `time_s` after the start. Every engine gives its kernels this one, so that
// they draw the same random numbers.
kernels::MfMoment moment_of(const kernels::MfNoise& noise, std::uint64_t tick, double time_s) noexcept;

}  // namespace mayfly
