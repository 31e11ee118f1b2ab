// What a simulated HAL is made of. Plain data: the program fills it in from a scenario.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/clock.hpp"
#include "core/hal.hpp"
#include "sim_hal/fault_script.hpp"
#include "sim_hal/pose_view.hpp"

namespace mayfly::sim_hal {

// See kernels/plants.h for the equations.
enum class Plant : std::uint8_t { kIdeal, kVelocityLag, kDoubleIntegrator };

// What steps the plants. Both give the same bits.
enum class Backend : std::uint8_t {
  kAutomatic,  // OpenCL where there is a device, else native; SimHal::backend_note() says why
  kOpenCl,
  kNative,
};

// What goes wrong on the way from a robot to read(). A sample is one robot's pose at one plant step; all that
// happens to it follows from the seed, the robot and the step, so that it is the same in every run.
struct Faults {
  float pose_noise = 0.0F;  // m, standard deviation of each coordinate
  float delay = 0.0F;       // s from measuring to handing over; rounded up to whole reads
  float dropout = 0.0F;     // probability that a sample is lost (its `valid` is 0)
  float freeze = 0.0F;      // probability, a robot and second, that a freeze begins
  float freeze_time =
      0.5F;          // s that a frozen robot's values stay the same while its stamps go on; at most 60
  float nan = 0.0F;  // probability that a sample is NaN and claims to be valid: a peer with a bug
};

// Sees the robots as they really are, at every plant step, and what they are told: for tests of what the
// controller promises. In lock step only.
class StepWatcher {
 public:
  virtual ~StepWatcher() = default;
  virtual void on_step(const PoseView& truth) noexcept = 0;
  virtual void on_command(Time now, const CommandColumns& commands) noexcept = 0;
};

struct SimHalConfig {
  std::string name = "sim";
  std::vector<std::string> robot_names;
  std::vector<glm::vec3> positions;  // m, at the start; one a robot
  Plant plant = Plant::kIdeal;
  float time_constant = 0.1F;  // s, velocity lag
  double rate_hz = 200.0;      // of plant steps, 1 to 5000; resolved to a thousandth
  // What a robot can do, whatever it is told: m/s and m/s². Empty: no limit; one value: for all; else one a
  // robot.
  std::vector<float> max_speed;
  std::vector<float> max_acceleration;
  Faults faults;
  std::vector<ScriptedFault> script;  // what goes wrong at set times
  // m: where a robot that lands comes to rest.
  float ground = -std::numeric_limits<float>::infinity();
  int links = 1;                   // that the robots are dealt to, in equal parts
  float endurance = 0.0F;          // s that a full battery lasts; 0: for ever
  StepWatcher* watcher = nullptr;  // sees every plant step in lock step; must outlive the HAL
  std::uint64_t seed = 1;
  Backend backend = Backend::kAutomatic;
  // True: time passes only in read and write, in whole plant steps, and a run is reproducible bit for bit.
  // False: a thread steps the plants as `clock` goes; read and write only meet it at mailboxes.
  bool lock_step = true;
  Clock* clock =
      nullptr;  // the run's; needed unless lock_step; must outlive the HAL and allow calls from any thread
};

}  // namespace mayfly::sim_hal
