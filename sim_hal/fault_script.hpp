// What goes wrong at a set time: who, from when, for how long. A table that is looked up, never a state, so
// that a fault does not depend on when, or how often, somebody reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "core/clock.hpp"
#include "core/hal.hpp"

namespace mayfly::sim_hal {

enum class Effect : std::uint8_t {
  kLinkLost,     // as kSilent, of every robot on the robots' links; read() and write() say which is down
  kSilent,       // nothing is heard of the robot and no command reaches it; its pose is seen from outside
  kLinkLoss,     // `size` is the share of polls and of commands that are lost
  kLinkLatency,  // commands and answers are `size` seconds late
  kPoseStale,    // no sample
  kPoseFrozen,   // the last sample before, with fresh stamps
  kPoseNan,      // not a number, and claims to be valid
  kPoseJump,     // told `size` metres off, along `direction`
  kPoseGhost,    // told `size` metres off, along `direction`, and where it is, in turn
  kIdSwap,       // the first two robots are told in each other's place
  kWind,         // `size` m/s along `direction` are added to what the robot is told
  kWeakMotor,    // `size` is the share that is left of its speed and acceleration
  kBatteryLow,   // the charge is told as `size`, or less
  kBatteryJump,  // the charge is told `size` lower
  kBatteryNan,
  kSimulationFails,  // the plants' stepper: for good
};

struct RobotRange {
  RobotIndex first = 0;
  RobotIndex count = 0;
};

struct ScriptedFault {
  Effect effect = Effect::kSilent;
  std::vector<RobotRange> robots;  // indices into the HAL's own robots
  Time from{0};                    // since the HAL's first activation
  Time until = Time::max();
  float size = 0.0F;
  glm::vec3 direction{1.0F, 0.0F, 0.0F};  // of length 1

  bool is_on(Time time) const noexcept { return time >= from && time < until; }
  // The robot of this number, counted through the ranges; kEveryRobot where there are not so many.
  RobotIndex robot(std::size_t number) const noexcept {
    for (const RobotRange& range : robots) {
      if (number < range.count) {
        return range.first + static_cast<RobotIndex>(number);
      }
      number -= range.count;
    }
    return kEveryRobot;
  }
};

class FaultScript {
 public:
  explicit FaultScript(std::vector<ScriptedFault> faults = {}) : faults_(std::move(faults)) {}

  bool has(Effect effect) const noexcept {
    for (const ScriptedFault& fault : faults_) {
      if (fault.effect == effect) {
        return true;
      }
    }
    return false;
  }
  // Calls `act(fault)` for each fault of this kind, in the order of the script.
  template <class Act>
  void each(Effect effect, Act&& act) const noexcept {
    for (const ScriptedFault& fault : faults_) {
      if (fault.effect == effect) {
        act(fault);
      }
    }
  }
  // Calls `act(robot, fault)` for each robot that such a fault is on for, at `time` since the activation.
  template <class Act>
  void each_robot(Effect effect, Time time, Act&& act) const noexcept {
    each(effect, [&](const ScriptedFault& fault) {
      if (!fault.is_on(time)) {
        return;
      }
      for (const RobotRange& range : fault.robots) {
        for (RobotIndex robot = range.first; robot < range.first + range.count; ++robot) {
          act(robot, fault);
        }
      }
    });
  }
  bool empty() const noexcept { return faults_.empty(); }
  const std::vector<ScriptedFault>& faults() const noexcept { return faults_; }

 private:
  std::vector<ScriptedFault> faults_;
};

}  // namespace mayfly::sim_hal
