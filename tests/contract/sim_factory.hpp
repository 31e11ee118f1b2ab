// Simulated HALs for tests: robots in a row, a metre apart, in lock step.
#pragma once

#include <memory>
#include <string>

#include "sim_hal/sim_hal.hpp"

namespace mayfly::sim_hal {

inline SimHalConfig row_of(std::size_t robots, Plant plant = Plant::kVelocityLag,
                           Backend backend = Backend::kNative, const std::string& prefix = "fly") {
  SimHalConfig config;
  config.plant = plant;
  config.backend = backend;
  config.max_speed = {5.0F};
  config.max_acceleration = {20.0F};
  for (std::size_t robot = 0; robot < robots; ++robot) {
    config.robot_names.push_back(prefix + std::to_string(robot));
    config.positions.emplace_back(static_cast<float>(robot), 0.0F, 10.0F);
  }
  return config;
}

}  // namespace mayfly::sim_hal
