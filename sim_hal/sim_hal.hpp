// A HAL whose robots are simulated: a peer of the real ones, with their faults.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/hal.hpp"
#include "sim_hal/config.hpp"
#include "sim_hal/plant_run.hpp"
#include "sim_hal/plant_thread.hpp"
#include "sim_hal/radio.hpp"
#include "sim_hal/sensor.hpp"

namespace mayfly::sim_hal {

// The link of a HAL's robot, of so many robots: the HAL's own name where it has but one link, else
// "sim/0" and so on.
std::string link_name(const std::string& hal, int links, std::size_t robot, std::size_t robots);

// How the robots answer: kVelocity is obeyed until the command's deadline, within the robot's own limits;
// kLand sinks straight down at 0.5 m/s to the ground, where the motors stop (whoever is below is not minded:
// that is the guard's); kTakeOff climbs from there to 0.5 m above it; everything else makes a robot hold,
// which is to want velocity 0. Simulated robots are in the air from the start. A robot that hears nothing
// obeys the last that it heard until its deadline. After deactivate() they hold, and time goes on: at the
// next activate() they have stopped wherever that took them.
class SimHal final : public Hal {
 public:
  explicit SimHal(SimHalConfig config);

  std::span<const RobotInfo> robots() const noexcept override { return infos_; }
  std::string_view name() const noexcept override { return config_.name; }

  // From configure() on: "native", or "opencl: " and the device; and why it is not the preferred one, if it
  // is not.
  std::string_view backend() const noexcept { return plants_ ? plants_->backend() : std::string_view{}; }
  std::string_view backend_note() const noexcept {
    return plants_ ? std::string_view(plants_->backend_note()) : std::string_view{};
  }
  const FaultCounters& fault_counters() const noexcept { return sensor_->counters(); }  // from configure() on

  // Where the robots really are, as of the last read() or write(). For metrics and tests in lock step, not
  // for control: no real robot tells this. Empty columns when not in lock step, or before configure().
  PoseView truth() noexcept;

 private:
  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override;
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override;
  HalResult failed(std::string_view cause) const noexcept;

  SimHalConfig config_;
  FaultScript script_;
  std::unique_ptr<Radio> radio_;
  std::vector<RobotInfo> infos_;
  std::optional<PlantRun> plants_;
  std::unique_ptr<Sensor> sensor_;
  std::unique_ptr<PlantThread> thread_;  // none in lock step
  PlantCommand command_;                 // lock step's own, while a write is under way
  bool started_ = false;
  Time origin_{0};  // the first activation
};

}  // namespace mayfly::sim_hal
