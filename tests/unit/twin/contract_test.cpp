// A HAL with twins before it is a HAL like any other, whoever flies.
#include "controller/twin/twin_hal.hpp"
#include "tests/contract/hal_contract.hpp"
#include "tests/contract/sim_factory.hpp"

namespace mayfly::contract {
namespace {

std::unique_ptr<TwinHal> twins_of(std::size_t robots) {
  TwinConfig config;
  config.robots.assign(robots, {5.0F, 20.0F});
  return std::make_unique<TwinHal>(std::make_unique<sim_hal::SimHal>(sim_hal::row_of(robots)), config);
}

// Takes every robot out as soon as there is a pose.
class AllOut final : public Hal {
 public:
  explicit AllOut(std::unique_ptr<TwinHal> twins) : twins_(std::move(twins)) {}
  std::span<const RobotInfo> robots() const noexcept override { return twins_->robots(); }
  std::string_view name() const noexcept override { return twins_->name(); }

 private:
  Result<void> do_configure() override { return twins_->configure(); }
  Result<void> do_activate(Time now) override {
    auto done = twins_->activate(now);
    for (RobotIndex r = 0; r < robots().size(); ++r) {
      static_cast<void>(twins_->take_out(r));
    }
    return done;
  }
  HalResult do_read(Time now, const StateColumns& states) noexcept override {
    return twins_->read(now, states);
  }
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override {
    return twins_->write(now, commands);
  }
  Result<void> do_deactivate(Time now) override { return twins_->deactivate(now); }

  std::unique_ptr<TwinHal> twins_;
};

INSTANTIATE_TEST_SUITE_P(Twins, HalContract,
                         ::testing::Values(HalFactory{"robots", twins_of},
                                           HalFactory{"twins",
                                                      [](std::size_t robots) {
                                                        return std::make_unique<AllOut>(twins_of(robots));
                                                      }}),
                         name_of);

}  // namespace
}  // namespace mayfly::contract
