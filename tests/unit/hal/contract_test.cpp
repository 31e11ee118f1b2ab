// Every HAL there is, under the one contract.
#include "controller/composite_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/sim_factory.hpp"

// The example's own class: what a reader copies must keep the contract as well.
#define main own_hal_main  // NOLINT(readability-identifier-naming)
#include "examples/own_hal.cpp"
#undef main

namespace mayfly::contract {

namespace {

using sim_hal::Backend;
using sim_hal::Plant;
using sim_hal::row_of;
using sim_hal::SimHal;

HalFactory simulated(const std::string& name, Plant plant, Backend backend) {
  return {name, [plant, backend](std::size_t robots) {
            return std::make_unique<SimHal>(row_of(robots, plant, backend));
          }};
}

// One robot in the first, none in the second, the rest in the third.
std::unique_ptr<Hal> composite(std::size_t robots) {
  const std::size_t first = robots > 0 ? 1 : 0;
  std::vector<std::unique_ptr<Hal>> children;
  children.push_back(std::make_unique<SimHal>(row_of(first, Plant::kIdeal, Backend::kNative, "a")));
  children.push_back(std::make_unique<SimHal>(row_of(0)));
  children.push_back(
      std::make_unique<SimHal>(row_of(robots - first, Plant::kVelocityLag, Backend::kNative, "b")));
  return std::make_unique<CompositeHal>("all", std::move(children));
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Native, HalContract,
                         ::testing::Values(simulated("ideal", Plant::kIdeal, Backend::kNative),
                                           simulated("velocity_lag", Plant::kVelocityLag, Backend::kNative),
                                           simulated("double_integrator", Plant::kDoubleIntegrator,
                                                     Backend::kNative)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(OpenCl, HalContract,
                         ::testing::Values(simulated("ideal", Plant::kIdeal, Backend::kOpenCl),
                                           simulated("velocity_lag", Plant::kVelocityLag, Backend::kOpenCl),
                                           simulated("double_integrator", Plant::kDoubleIntegrator,
                                                     Backend::kOpenCl)),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Composite, HalContract, ::testing::Values(HalFactory{"composite", composite}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Example, HalContract,
                         ::testing::Values(HalFactory{
                             "own_hal", [](std::size_t robots) { return std::make_unique<MyHal>(robots); }}),
                         name_of);

}  // namespace mayfly::contract
