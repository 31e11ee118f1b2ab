// Whether a simulated HAL can be made of what it was given.
#pragma once

#include "core/result.hpp"
#include "sim_hal/config.hpp"

namespace mayfly::sim_hal {

// Fails (caller) with what is wrong: numbers out of range or not finite, columns of different lengths, a name
// twice, no clock where one is needed.
Result<void> check(const SimHalConfig& config);

}  // namespace mayfly::sim_hal
