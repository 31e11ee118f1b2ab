// The way between a robot and its link: what is heard of it, and which commands get there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/hal.hpp"
#include "sim_hal/fault_script.hpp"
#include "sim_hal/random.hpp"

namespace mayfly::sim_hal {

// One thread. Times are the run's; a script's are since `origin`, the first activation. `script` must outlive
// it.
class Radio {
 public:
  // `robots` have a link each, by its name; they outlive it. `hal` is told where several links are down.
  Radio(std::span<const RobotInfo> robots, std::string_view hal, const FaultScript& script,
        std::uint64_t seed, float endurance_s);

  void start(Time now) noexcept;
  // Asks every robot once, which a read does. Tells of the first that does not answer.
  HalResult poll(Time now) noexcept;
  // `airborne`: one a robot.
  void tell(Time now, std::span<const std::uint8_t> airborne, std::span<Telemetry> to) const noexcept;
  // Whether a command that is sent now gets to each robot, and how much later; one element a robot. Tells of
  // a link that is down.
  HalResult send(Time now, std::span<std::uint8_t> reaches, std::span<Time> late) noexcept;

 private:
  // How many polls of a robot, and how many of them it answered, in each slice of the last second.
  static constexpr std::size_t kSlices = 20;
  struct Answers {
    std::array<std::uint16_t, kSlices> polls{}, answered{};
  };

  HalResult link_state(Time since) const noexcept;
  void mark_lost(Time since, std::int64_t number, Draw what, std::span<std::uint8_t> answers) const noexcept;
  void mark_late(Time since, std::span<Time> late) const noexcept;
  void turn_slices(Time now) noexcept;
  float charge(Time since, RobotIndex robot) const noexcept;

  std::span<const RobotInfo> robots_;
  std::string_view hal_;
  const FaultScript* script_;
  std::uint64_t seed_;
  float endurance_s_;
  bool never_fails_;  // nothing in the script is about links
  bool started_ = false;
  Time origin_{0};
  Time heard_{0};  // where nothing ever fails: of all
  std::int64_t slice_ = 0;
  std::int64_t polls_ = 0, sends_ = 0;
  Time polled_{0};                     // the last time before this one
  std::vector<std::uint8_t> answers_;  // of the poll under way
  std::vector<Time> late_;             // its answers
  std::vector<Time> heard_of_;
  std::vector<Answers> windows_;
};

}  // namespace mayfly::sim_hal
