// What is wrong with a robot's link and battery, by its telemetry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/safety/symptoms.hpp"
#include "core/hal.hpp"

namespace mayfly {

struct TelemetryLimits {
  Time silent_after{std::chrono::milliseconds(200)};   // nothing heard for longer: kSilent
  float least_link_quality = 0.85F;                    // share of the polls that are answered
  float battery_low = 0.3F, battery_critical = 0.15F;  // share of the charge
  float battery_jump = 0.2F;  // more than this from one tick to the next is no charge
};

// A HAL that does not tell something leaves it at Telemetry's defaults, of which nothing follows. What a HAL
// once told, it must go on telling.
class TelemetryWatch {
 public:
  TelemetryWatch(std::size_t robots, const TelemetryLimits& limits);

  // One element a robot in each; `stamp` is of its newest pose, which counts as an answer where the link does
  // not tell of any: a pose may be measured from outside. `known` is 0 for one that was never heard: it
  // cannot fall silent.
  void update(Time now, std::span<const Telemetry> telemetry, std::span<const Time> stamp,
              std::span<const std::uint8_t> known) noexcept;
  std::span<const Symptoms> symptoms() const noexcept { return symptoms_; }

 private:
  void judge_battery(std::size_t robot, float charge) noexcept;

  TelemetryLimits limits_;
  std::vector<float> charge_;  // share, as told last where that was a number; NaN where it never was
  std::vector<std::uint8_t> heard_;
  std::vector<Symptoms> symptoms_;
};

}  // namespace mayfly
