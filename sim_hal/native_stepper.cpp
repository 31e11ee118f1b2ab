#include <vector>

#include "sim_hal/plant_constants.hpp"
#include "sim_hal/plant_stepper.hpp"

namespace mayfly::sim_hal {

namespace {

using Run = void (*)(float* block, int stride, kernels::MfPlant plant);

template <int kKind>
void run(float* block, int stride, kernels::MfPlant plant) {
  for (int first = 0; first < stride; first += MF_LANES) {
    kernels::mf_run_plant(block, stride, first, plant, kKind);
  }
}

Run run_of(Plant plant) {
  switch (plant) {
    case Plant::kVelocityLag:
      return run<MF_PLANT_VELOCITY_LAG>;
    case Plant::kDoubleIntegrator:
      return run<MF_PLANT_DOUBLE_INTEGRATOR>;
    case Plant::kIdeal:
      break;
  }
  return run<MF_PLANT_IDEAL>;
}

class NativeStepper final : public PlantStepper {
 public:
  NativeStepper(std::size_t robots, const PlantParameters& parameters)
      : constants_(plant_constants(parameters)),
        run_(run_of(parameters.plant)),
        stride_(padded(robots)),
        values_(MF_PLANT_COLUMNS * stride_) {}

  std::string_view backend() const noexcept override { return "native"; }
  PlantBlock block() noexcept override { return {values_, stride_}; }
  std::string_view step(std::uint32_t count) noexcept override {
    kernels::MfPlant plant = constants_;
    plant.steps = static_cast<int>(count);
    run_(values_.data(), static_cast<int>(stride_), plant);
    return {};
  }

 private:
  kernels::MfPlant constants_;
  Run run_;
  std::size_t stride_;
  std::vector<float> values_;
};

}  // namespace

std::unique_ptr<PlantStepper> make_native_stepper(std::size_t robots, const PlantParameters& parameters) {
  return std::make_unique<NativeStepper>(robots, parameters);
}

Result<ChosenStepper> make_stepper(Backend backend, std::size_t robots, const PlantParameters& parameters) {
  if (backend == Backend::kNative) {
    return ChosenStepper{make_native_stepper(robots, parameters), {}};
  }
  auto opencl = make_opencl_stepper(robots, parameters);
  if (opencl) {
    return ChosenStepper{std::move(*opencl), {}};
  }
  if (backend == Backend::kOpenCl) {
    return fail(std::move(opencl.error()));
  }
  return ChosenStepper{make_native_stepper(robots, parameters),
                       "plants are stepped by the native engine: " + to_string(opencl.error())};
}

}  // namespace mayfly::sim_hal
