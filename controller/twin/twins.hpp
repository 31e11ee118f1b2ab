// The twins of a HAL's robots, and who of them flies. For twin_hal.cpp only.
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/twin/twin_hal.hpp"

namespace mayfly {

class TwinHal::Twins {
 public:
  explicit Twins(const TwinConfig& config);

  // Any thread.
  bool ask(RobotIndex robot, bool out) noexcept;
  bool flies(RobotIndex robot) const noexcept;
  TwinReport report(RobotIndex robot) const noexcept;

  // Everybody is himself again, and nothing is asked.
  void restart(Time now) noexcept;
  // Lets time pass for all twins. Those that do not fly keep the velocity of their robot's commands.
  void advance(Time now) noexcept;
  void command(const CommandColumns& commands) noexcept;
  // Before a read: a HAL that fails and writes nothing must not hand a twin back as its robot.
  void hide(const StateColumns& states) const noexcept;
  // What the robots told.
  void hear(const StateColumns& states) noexcept;
  void do_what_was_asked(Time now) noexcept;
  // Puts the twins that fly in their robots' place.
  void show(Time now, const StateColumns& states) const noexcept;
  // What the robots themselves are told.
  std::span<const CommandKind> park(std::span<const CommandKind> kinds) noexcept;
  Time now() const noexcept { return at_; }
  RealPose real_pose(RobotIndex robot) const noexcept { return robots_[robot].real; }

 private:
  using Vector = Eigen::RowVector3d;
  enum class Ask : std::uint8_t { kNothing, kOut, kBack };
  struct Robot {
    RealPose real;
    bool told = false;  // has had a command since the activation
    Vector wanted = Vector::Zero();
    Vector place = Vector::Zero();  // of the twin, where it flies
    Vector velocity = Vector::Zero();
  };
  // Shared with whoever asks.
  struct Desk {
    std::atomic<Ask> asked{Ask::kNothing};
    std::atomic<bool> flies{false};
    std::atomic<TwinOutcome> outcome{TwinOutcome::kNone};
    std::atomic<float> distance{0.0F}, speed{0.0F};
  };

  void pass(double seconds, bool commanded) noexcept;
  // Where the real robot is now; false where nobody knows.
  bool locate(const Robot& robot, Time now, Vector& place, Vector& velocity) const noexcept;
  TwinOutcome take_out(Robot& robot, Time now) noexcept;
  TwinOutcome put_back(const Robot& robot, Desk& desk, Time now) noexcept;

  const TwinConfig& config_;
  std::vector<Robot> robots_;
  std::vector<Desk> desks_;
  std::vector<CommandKind> kinds_;
  Time at_{0};
  Time deadline_{0};
};

}  // namespace mayfly
