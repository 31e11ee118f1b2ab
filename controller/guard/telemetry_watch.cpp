#include "controller/guard/telemetry_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mayfly {

TelemetryWatch::TelemetryWatch(std::size_t robots, const TelemetryLimits& limits)
    : limits_(limits),
      charge_(robots, std::numeric_limits<float>::quiet_NaN()),
      heard_(robots),
      symptoms_(robots) {}

void TelemetryWatch::update(Time now, std::span<const Telemetry> telemetry, std::span<const Time> stamp,
                            std::span<const std::uint8_t> known) noexcept {
  for (std::size_t robot = 0; robot < symptoms_.size(); ++robot) {
    symptoms_[robot] = {};
    const Telemetry& told = telemetry[robot];
    heard_[robot] = heard_[robot] != 0 || known[robot] != 0 || told.heard > Time{0} ? 1 : 0;
    const Time heard = told.heard > Time{0} ? told.heard : stamp[robot];
    if (heard_[robot] != 0 && now - heard > limits_.silent_after) {
      symptoms_[robot].add(Symptom::kSilent);
    }
    if (told.link_quality < limits_.least_link_quality) {
      symptoms_[robot].add(Symptom::kLinkDegraded);
    }
    judge_battery(robot, told.battery);
  }
}

void TelemetryWatch::judge_battery(std::size_t robot, float charge) noexcept {
  const float before = charge_[robot];
  const bool was_told = !std::isnan(before);
  if (!std::isfinite(charge)) {
    if (was_told || std::isinf(charge)) {
      symptoms_[robot].add(Symptom::kBatteryUnknown);
    }
    return;
  }
  if (was_told && std::fabs(charge - before) > limits_.battery_jump) {
    symptoms_[robot].add(Symptom::kBatteryUnknown);
  }
  charge_[robot] = charge;
  if (charge < limits_.battery_critical) {
    symptoms_[robot].add(Symptom::kBatteryCritical);
  } else if (charge < limits_.battery_low) {
    symptoms_[robot].add(Symptom::kBatteryLow);
  }
}

}  // namespace mayfly
