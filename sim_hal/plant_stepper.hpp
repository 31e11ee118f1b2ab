// Who steps the plants: the same lane functions, compiled into this program or into an OpenCL kernel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "sim_hal/config.hpp"

namespace mayfly::sim_hal {

// The robots' columns as kernels/plants.h lays them out, MF_PLANT_COLUMNS of `stride` floats.
struct PlantBlock {
  std::span<float> values;
  std::size_t stride = 0;

  std::span<float> column(int index, std::size_t robots) const noexcept {
    return values.subspan(static_cast<std::size_t>(index) * stride, robots);
  }
};

class PlantStepper {
 public:
  PlantStepper() = default;
  PlantStepper(const PlantStepper&) = delete;
  PlantStepper& operator=(const PlantStepper&) = delete;
  virtual ~PlantStepper() = default;

  // "native", or "opencl: " and the device's name.
  virtual std::string_view backend() const noexcept = 0;
  // Valid until the next step().
  virtual PlantBlock block() noexcept = 0;
  // Takes `count` steps and returns when they are done. Empty, or a literal that names what failed; after a
  // failure the stepper stays failed and block() may be empty.
  virtual std::string_view step(std::uint32_t count) noexcept = 0;
};

struct PlantParameters {
  Plant plant = Plant::kIdeal;
  float time_constant = 0.1F;  // s
  double rate_hz = 200.0;
};

std::unique_ptr<PlantStepper> make_native_stepper(std::size_t robots, const PlantParameters& parameters);
// Fails (environment) where there is no OpenCL device, or its compiler does not work.
Result<std::unique_ptr<PlantStepper>> make_opencl_stepper(std::size_t robots,
                                                          const PlantParameters& parameters);

struct ChosenStepper {
  std::unique_ptr<PlantStepper> stepper;
  std::string note;  // why it is not the preferred one; empty if it is
};
Result<ChosenStepper> make_stepper(Backend backend, std::size_t robots, const PlantParameters& parameters);

}  // namespace mayfly::sim_hal
