// From a plant's parameters to what its kernel is given.
#pragma once

#include <cmath>
#include <cstddef>

#include "kernels/plants.h"
#include "sim_hal/plant_stepper.hpp"

namespace mayfly::sim_hal {

inline kernels::MfPlant plant_constants(const PlantParameters& parameters) {
  const double dt = 1.0 / parameters.rate_hz;
  const double tau = static_cast<double>(parameters.time_constant);
  // A time constant of 0 is the limit: the command at once.
  const double decay = tau > 0.0 ? std::exp(-dt / tau) : 0.0;
  return {static_cast<float>(dt), static_cast<float>(decay), static_cast<float>(tau * (1.0 - decay)), 0};
}

inline std::size_t padded(std::size_t robots) {
  constexpr std::size_t kLanes = MF_LANES;
  return (robots + kLanes - 1) / kLanes * kLanes;
}

}  // namespace mayfly::sim_hal
