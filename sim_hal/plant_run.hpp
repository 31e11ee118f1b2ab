// The simulated robots themselves: plants that go on in whole steps and obey the newest command until its
// deadline.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/clock.hpp"
#include "core/result.hpp"
#include "sim_hal/config.hpp"
#include "sim_hal/plant_stepper.hpp"
#include "sim_hal/pose_view.hpp"
#include "sim_hal/step_clock.hpp"

namespace mayfly::sim_hal {

// Velocities that the robots are told, m/s; 0 for a robot that holds. One element a robot in each column.
struct VelocityCommand {
  explicit VelocityCommand(std::size_t robots = 0) : x(robots), y(robots), z(robots) {}
  std::vector<float> x, y, z;
  Time deadline{0};  // from here on every robot holds
};

// One thread at a time. Nothing but create() allocates.
class PlantRun {
 public:
  // `config` has been checked.
  static Result<PlantRun> create(const SimHalConfig& config);

  // Time begins, or goes on after a pause, during which the robots held.
  void resume(Time now) noexcept;
  // Takes all whole steps up to `now`. Empty, or a literal that names what failed; a failure is for good.
  std::string_view advance(Time now) noexcept;
  void command(const VelocityCommand& command) noexcept;
  void hold() noexcept;
  // As of the last advance(); valid until the next.
  PoseView view() noexcept;

  std::string_view backend() const noexcept { return stepper_->backend(); }
  const std::string& backend_note() const noexcept { return note_; }

 private:
  PlantRun(ChosenStepper chosen, std::size_t robots, double rate_hz);
  bool step(std::int64_t count) noexcept;

  std::unique_ptr<PlantStepper> stepper_;
  std::string note_;
  std::size_t robots_;
  double rate_hz_;
  StepClock steps_;
  bool started_ = false;
  bool holding_ = true;
  std::int64_t done_ = 0;
  Time deadline_{0};
  std::string_view failure_;
};

}  // namespace mayfly::sim_hal
