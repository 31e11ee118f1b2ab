// The way from a robot's true motion to what read() tells of it, with all that goes wrong on the way.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/hal.hpp"
#include "sim_hal/config.hpp"
#include "sim_hal/fault_script.hpp"
#include "sim_hal/pose_ring.hpp"
#include "sim_hal/pose_view.hpp"

namespace mayfly::sim_hal {

// How many samples each fault has touched.
struct FaultCounters {
  std::atomic<std::uint64_t> noisy{0};
  std::atomic<std::uint64_t> delayed{0};   // told later than they were measured
  std::atomic<std::uint64_t> withheld{0};  // nothing old enough yet, so nothing was told
  std::atomic<std::uint64_t> dropped{0};
  std::atomic<std::uint64_t> frozen{0};
  std::atomic<std::uint64_t> nans{0};
};

class Sensor {
 public:
  // `script` must outlive it.
  Sensor(std::size_t robots, const Faults& faults, std::uint64_t seed, double rate_hz,
         const FaultScript& script);

  // Forgets the past: what was measured before an activation is not told after it.
  void restart() noexcept;
  // `newest` is the state of all robots, `now` the time of the read, `since_start` that since the HAL's first
  // activation. Allocates nothing.
  void deliver(Time now, Time since_start, const PoseView& newest, const StateColumns& states) noexcept;
  const FaultCounters& counters() const noexcept { return counters_; }

 private:
  void measure(Time now, const PoseView& newest, const StateColumns& states) noexcept;
  void follow_script(Time since_start, const StateColumns& states) noexcept;
  void freeze_by_script(Time since_start, const StateColumns& states) noexcept;
  bool any_per_robot() const noexcept;
  void deliver_robot(std::uint32_t robot, const PoseView& sample, const StateColumns& states) noexcept;
  bool is_frozen(std::uint32_t robot, Time when) const noexcept;
  void add_noise(std::uint32_t robot, std::int64_t step, const StateColumns& states) noexcept;

  Faults faults_;
  const FaultScript* script_;
  std::uint64_t seed_;
  std::optional<PoseRing> past_;        // only where there is a delay
  std::vector<std::uint8_t> was_told_;  // whether `told_` holds a value of this robot
  PoseSample told_;                     // the last values of each robot that were not frozen
  PoseSample held_;  // the values that a freeze of the script goes on telling; only where it has one
  FaultCounters counters_;
};

}  // namespace mayfly::sim_hal
