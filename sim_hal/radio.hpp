// The way between a robot and its link: what is heard of it, and which commands get there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/hal.hpp"
#include "sim_hal/fault_script.hpp"
#include "sim_hal/random.hpp"

namespace mayfly::sim_hal {

// One thread. Times are the run's; a script's are since `origin`, the first activation. `script` must outlive
// it.
class Radio {
 public:
  Radio(std::size_t robots, const FaultScript& script, std::uint64_t seed, float endurance_s);

  void start(Time now) noexcept;
  // Asks every robot once, which a read does. Tells of the first that does not answer.
  HalResult poll(Time now) noexcept;
  // `airborne`: one a robot.
  void tell(Time now, std::span<const std::uint8_t> airborne, std::span<Telemetry> to) const noexcept;
  // Whether a command that is sent now gets to each robot; one element a robot. Tells of a link that is down.
  HalResult send(Time now, std::span<std::uint8_t> reaches) noexcept;

 private:
  // How many polls of a robot, and how many of them it answered, in each slice of the last second.
  static constexpr std::size_t kSlices = 20;
  struct Answers {
    std::array<std::uint16_t, kSlices> polls{}, answered{};
  };

  void mark_lost(Time since, std::int64_t number, Draw what, std::span<std::uint8_t> answers) const noexcept;
  void turn_slices(Time now) noexcept;
  float charge(Time since, RobotIndex robot) const noexcept;

  const FaultScript* script_;
  std::uint64_t seed_;
  float endurance_s_;
  bool never_fails_;  // nothing in the script is about links
  bool started_ = false;
  Time origin_{0};
  Time heard_{0};  // where nothing ever fails: of all
  std::int64_t slice_ = 0;
  std::int64_t polls_ = 0, sends_ = 0;
  std::vector<std::uint8_t> answers_;  // of the poll under way
  std::vector<Time> heard_of_;
  std::vector<Answers> windows_;
};

}  // namespace mayfly::sim_hal
