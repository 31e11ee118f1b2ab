#include "compute/buffer.hpp"
#include "compute/device.hpp"
#include "compute/program.hpp"
#include "sim_hal/plant_constants.hpp"
#include "sim_hal/plant_stepper.hpp"

namespace mayfly::sim_hal {

namespace {

// Fixed, so that the runtime compiles each kernel once and not for every number of robots.
constexpr std::size_t kGroup = 16;

const char* kernel_of(Plant plant) {
  switch (plant) {
    case Plant::kVelocityLag:
      return "step_velocity_lag";
    case Plant::kDoubleIntegrator:
      return "step_double_integrator";
    case Plant::kIdeal:
      break;
  }
  return "step_ideal";
}

class OpenClStepper final : public PlantStepper {
 public:
  OpenClStepper(const compute::Device& device, compute::Buffer<float> block, compute::Kernel kernel,
                std::size_t stride, const PlantParameters& parameters)
      : backend_("opencl: " + device.info().name),
        block_(std::move(block)),
        kernel_(std::move(kernel)),
        stride_(stride),
        constants_(plant_constants(parameters)) {}

  std::string_view backend() const noexcept override { return backend_; }
  PlantBlock block() noexcept override { return {block_.data(), stride_}; }
  std::string_view step(std::uint32_t count) noexcept override {
    if (stride_ == 0) {
      return {};
    }
    if (!block_.unmap().ok()) {
      return "OpenCL: the device did not take the robots' columns";
    }
    kernels::MfPlant plant = constants_;
    plant.steps = static_cast<int>(count);
    const std::size_t items = (stride_ / MF_LANES + kGroup - 1) / kGroup * kGroup;
    if (!kernel_.set(block_, static_cast<int>(stride_), plant).ok() || !kernel_.enqueue(items, kGroup).ok()) {
      return "OpenCL: the plants' kernel could not be launched";
    }
    return block_.map().ok() ? std::string_view{}
                             : "OpenCL: the device did not give the robots' columns back";
  }

 private:
  std::string backend_;
  compute::Buffer<float> block_;
  compute::Kernel kernel_;
  std::size_t stride_;
  kernels::MfPlant constants_;
};

}  // namespace

Result<std::unique_ptr<PlantStepper>> make_opencl_stepper(std::size_t robots,
                                                          const PlantParameters& parameters) {
  auto device = compute::Device::open();
  if (!device) {
    return fail(std::move(device.error()));
  }
  auto program = compute::Program::build(*device, "plants");
  if (!program) {
    return fail(std::move(program.error()));
  }
  auto kernel = program->kernel(kernel_of(parameters.plant));
  if (!kernel) {
    return fail(std::move(kernel.error()));
  }
  const std::size_t stride = padded(robots);
  auto block = compute::Buffer<float>::create(*device, MF_PLANT_COLUMNS * stride);
  if (!block) {
    return fail(std::move(block.error()));
  }
  auto stepper =
      std::make_unique<OpenClStepper>(*device, std::move(*block), std::move(*kernel), stride, parameters);
  // The first launch compiles: now, not in flight.
  if (const std::string_view failure = stepper->step(0); !failure.empty()) {
    return fail(Cause::kEnvironment, std::string(failure));
  }
  return stepper;
}

}  // namespace mayfly::sim_hal
