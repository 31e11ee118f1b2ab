// The simulated robots themselves: plants that go on in whole steps and obey the newest command until its
// deadline.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/clock.hpp"
#include "core/hal.hpp"
#include "core/result.hpp"
#include "sim_hal/config.hpp"
#include "sim_hal/fault_script.hpp"
#include "sim_hal/plant_stepper.hpp"
#include "sim_hal/pose_view.hpp"
#include "sim_hal/step_clock.hpp"

namespace mayfly::sim_hal {

// What the robots are told: velocities in m/s, which count for kVelocity. One element a robot in each column.
struct PlantCommand {
  explicit PlantCommand(std::size_t robots = 0)
      : kind(robots, CommandKind::kHold), reaches(robots, 1), late(robots), x(robots), y(robots), z(robots) {}
  std::vector<CommandKind> kind;
  std::vector<std::uint8_t> reaches;  // 0: this robot does not hear it
  std::vector<Time> late;             // after `sent` it gets there
  std::vector<float> x, y, z;
  Time sent{0};
  Time deadline{0};  // from here on every robot that heard it holds
};

// One thread at a time. Nothing but create() allocates.
class PlantRun {
 public:
  // `config` has been checked, and outlives it; so does `script`.
  static Result<PlantRun> create(const SimHalConfig& config, const FaultScript& script);

  // Time begins, or goes on after a pause, during which the robots held.
  void resume(Time now) noexcept;
  // Takes all whole steps up to `now`. Empty, or a literal that names what failed; a failure is for good.
  std::string_view advance(Time now) noexcept;
  void command(const PlantCommand& command) noexcept;
  void hold() noexcept;
  // As of the last advance(); valid until the next.
  PoseView view() noexcept;

  std::string_view backend() const noexcept { return stepper_->backend(); }
  const std::string& backend_note() const noexcept { return note_; }

 private:
  PlantRun(ChosenStepper chosen, const SimHalConfig& config, const FaultScript& script);
  void prepare_step() noexcept;
  void hear(std::size_t robot, const PlantCommand& command) noexcept;
  void hear_late(Time now) noexcept;
  void tell_robot(std::size_t robot, Time now) noexcept;
  void apply_script(Time since) noexcept;
  std::int64_t steps_ahead(std::int64_t until) const noexcept;
  void step(std::int64_t count) noexcept;
  void land() noexcept;

  std::unique_ptr<PlantStepper> stepper_;
  std::string note_;
  const SimHalConfig* config_;
  const FaultScript* script_;
  bool moved_by_script_;  // wind, weak motors: then every step is taken by itself
  std::size_t robots_;
  double rate_hz_;
  StepClock steps_;
  bool started_ = false;
  Time origin_{0};
  std::int64_t done_ = 0;
  PlantCommand told_;  // what each robot heard last
  std::vector<Time> deadline_;
  Time next_deadline_{0};                   // the first that has not passed
  bool is_new_ = false;                     // what the plants are told has to be worked out anew
  std::vector<PlantCommand> on_their_way_;  // a ring of the newest, where the script has late ones
  std::size_t newest_ = 0;                  // in it
  std::vector<Time> heard_;                 // when what each robot heard last was sent
  std::vector<std::uint8_t> airborne_;
  bool self_moving_ = false;  // somebody lands or takes off
  std::string_view failure_;
};

}  // namespace mayfly::sim_hal
