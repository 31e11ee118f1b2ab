// Robots taken out of a run, replaced by simulated twins, and put back, while everybody flies on.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/hal.hpp"
#include "core/result.hpp"

namespace mayfly {

struct TwinLimits {            // one a robot
  float speed = 3.0F;          // m/s
  float acceleration = 20.0F;  // m/s²
  float response_time = 0.0F;  // s: where it follows as a first-order lag, as its robot does; 0: at once
};

struct TwinConfig {
  std::vector<TwinLimits> robots;
  // A robot is put back no farther from its twin, and no faster past it, than this; m and m/s. What is seen
  // of it then jumps by no more.
  float most_distance = 0.05F;
  float most_speed = 0.1F;
  Time most_age{std::chrono::milliseconds(100)};  // of the poses by which a robot is taken out and put back
  CommandKind parked = CommandKind::kHold;        // what a robot is told while its twin flies; or kLand
};

// Refuses what is not finite or not positive, with the numbers.
Result<void> check(const TwinConfig& config);

enum class TwinOutcome : std::uint8_t {
  kNone,      // nothing was asked of it yet
  kPending,   // waits for the next read
  kTakenOut,  // its twin flies
  kPutBack,   // it flies itself
  kAlready,   // it was so before
  kNoPose,    // refused: its own pose is missing or too old
  kTooFar,    // … it is too far from its twin
  kTooFast,   // … it moves past its twin
};

// What became of the last request for a robot.
struct TwinReport {
  TwinOutcome outcome = TwinOutcome::kNone;
  float distance = 0.0F;  // m, of the robot from its twin when it was to be put back
  float speed = 0.0F;     // m/s, between the two
};

// A robot's own pose, whoever flies in its place; m and m/s, world frame.
struct RealPose {
  float x = 0.0F, y = 0.0F, z = 0.0F;
  float vx = 0.0F, vy = 0.0F, vz = 0.0F;
  Time stamp{0};
  bool valid = false;  // measured at least once since the activation
};

// Stands before a HAL, and is one. A twin starts where its robot is, at the velocity at which its commands
// have it, and follows its commands as the governor's reference does, so that it stays in its robot's tube:
// v⁺ is the command, or as near to it as a·T allows, and p⁺ = p + T(v + v⁺)/2; or dv/dt = (command − v)/τ
// where its robot is a lag. Without a valid command it brakes and holds.
//
// Nobody sees a robot whose twin flies: let it land, or keep clear of real_pose().
class TwinHal final : public Hal {
 public:
  TwinHal(std::unique_ptr<Hal> real, TwinConfig config);
  ~TwinHal() override;

  // From any thread once it is configured; done at the next read. False where there is no such robot, or
  // where it still waits for what was asked before.
  bool take_out(RobotIndex robot) noexcept;
  bool put_back(RobotIndex robot) noexcept;
  bool is_twin(RobotIndex robot) const noexcept;
  TwinReport report(RobotIndex robot) const noexcept;

  // As of the last read; on the thread that reads. Puts the twins that fly in their robots' place.
  void show_twins(const StateColumns& states) const noexcept;
  RealPose real_pose(RobotIndex robot) const noexcept;

  std::span<const RobotInfo> robots() const noexcept override { return real_->robots(); }
  std::string_view name() const noexcept override { return real_->name(); }
  const TwinConfig& config() const noexcept { return config_; }

 private:
  class Twins;

  Result<void> do_configure() override;
  Result<void> do_activate(Time now) override;
  HalResult do_read(Time now, const StateColumns& states) noexcept override;
  HalResult do_write(Time now, const CommandColumns& commands) noexcept override;
  Result<void> do_deactivate(Time now) override;

  std::unique_ptr<Hal> real_;
  TwinConfig config_;
  std::unique_ptr<Twins> twins_;
};

// For an operator: "taken out", "is 0.31 m from its twin; wanted at most 0.05 m".
std::string describe(const TwinReport& report, const TwinConfig& config);

}  // namespace mayfly
