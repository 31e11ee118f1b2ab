// A guard of governor and newest samples only.
#pragma once

#include <vector>

#include "controller/flight/estimate.hpp"
#include "controller/governor/governor.hpp"
#include "controller/guard/guard.hpp"

namespace mayfly::app {

class InterimGuard final : public Guard {
 public:
  // `hal` is configured and outlives it.
  InterimGuard(Governor governor, Hal& hal, Time command_life);

  HalResult sense(Time now) noexcept override;
  HalResult act(Time now, const CommandColumns& wish) noexcept override;
  EstimateColumns estimate() const noexcept override;
  std::span<const RobotState> states() const noexcept override { return states_; }
  std::span<const Severity> severities() const noexcept override { return severities_; }
  Severity acknowledge(Time) noexcept override { return Severity::kNone; }

 private:
  Governor governor_;
  Hal& hal_;
  Time command_life_;
  Estimate estimate_;
  std::vector<float> wish_x_, wish_y_, wish_z_, vx_, vy_, vz_;
  std::vector<CommandKind> kind_;
  std::vector<RobotState> states_;
  std::vector<Severity> severities_;
  std::vector<Symptoms> symptoms_;
  std::uint64_t sequence_ = 0;
};

}  // namespace mayfly::app
