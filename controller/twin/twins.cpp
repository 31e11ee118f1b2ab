#include "controller/twin/twins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

Eigen::RowVector3d vector(float x, float y, float z) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

Eigen::RowVector3d limited(const Eigen::RowVector3d& v, double most) {
  const double size = v.norm();
  return size > most ? Eigen::RowVector3d(v * (most / size)) : v;
}

}  // namespace

TwinHal::Twins::Twins(const TwinConfig& config)
    : config_(config),
      robots_(config.robots.size()),
      desks_(config.robots.size()),
      kinds_(config.robots.size()) {}

bool TwinHal::Twins::ask(RobotIndex robot, bool out) noexcept {
  if (robot >= desks_.size()) {
    return false;
  }
  Ask nothing = Ask::kNothing;
  return desks_[robot].asked.compare_exchange_strong(nothing, out ? Ask::kOut : Ask::kBack);
}

bool TwinHal::Twins::flies(RobotIndex robot) const noexcept {
  return robot < desks_.size() && desks_[robot].flies.load(std::memory_order_relaxed);
}

TwinReport TwinHal::Twins::report(RobotIndex robot) const noexcept {
  if (robot >= desks_.size()) {
    return {};
  }
  const Desk& desk = desks_[robot];
  if (desk.asked.load() != Ask::kNothing) {
    return {TwinOutcome::kPending, 0.0F, 0.0F};
  }
  return {desk.outcome.load(), desk.distance.load(), desk.speed.load()};
}

void TwinHal::Twins::restart(Time now) noexcept {
  at_ = deadline_ = now;
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    robots_[r] = {};
    desks_[r].asked = Ask::kNothing;
    desks_[r].flies = false;
    desks_[r].outcome = TwinOutcome::kNone;
  }
}

void TwinHal::Twins::advance(Time now) noexcept {
  if (now <= at_) {
    return;
  }
  const Time until = std::clamp(deadline_, at_, now);
  pass(to_seconds(until - at_), true);
  pass(to_seconds(now - until), false);
  at_ = now;
}

void TwinHal::Twins::pass(double seconds, bool commanded) noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    Robot& robot = robots_[r];
    const Vector wanted = commanded ? robot.wanted : Vector(Vector::Zero());
    const double lag = config_.robots[r].response_time;
    if (lag > 0.0) {
      const Vector behind = (wanted - robot.velocity) * std::exp(-seconds / lag);
      robot.place += seconds * wanted - lag * (wanted - robot.velocity - behind);
      robot.velocity = wanted - behind;
      continue;
    }
    const Vector change =
        limited(wanted - robot.velocity, static_cast<double>(config_.robots[r].acceleration) * seconds);
    robot.place += seconds * (robot.velocity + 0.5 * change);
    robot.velocity += change;
  }
}

void TwinHal::Twins::command(const CommandColumns& commands) noexcept {
  deadline_ = commands.deadline;
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    Robot& robot = robots_[r];
    robot.told = true;
    robot.wanted = Vector::Zero();
    if (commands.kind[r] == CommandKind::kVelocity) {
      robot.wanted = limited(vector(commands.vx[r], commands.vy[r], commands.vz[r]),
                             static_cast<double>(config_.robots[r].speed));
    }
  }
}

void TwinHal::Twins::hide(const StateColumns& states) const noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    states.valid[r] = desks_[r].flies.load(std::memory_order_relaxed) ? std::uint8_t{0} : states.valid[r];
  }
}

void TwinHal::Twins::hear(const StateColumns& states) noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    if (states.valid[r] != 0) {
      robots_[r].real = {states.x[r],  states.y[r],  states.z[r],     states.vx[r],
                         states.vy[r], states.vz[r], states.stamp[r], true};
    }
  }
}

void TwinHal::Twins::do_what_was_asked(Time now) noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    Desk& desk = desks_[r];
    const Ask asked = desk.asked.load();
    if (asked == Ask::kNothing) {
      continue;
    }
    TwinOutcome outcome = TwinOutcome::kAlready;
    if (desk.flies != (asked == Ask::kOut)) {
      outcome = asked == Ask::kOut ? take_out(robots_[r], now) : put_back(robots_[r], desk, now);
    }
    if (outcome == TwinOutcome::kTakenOut || outcome == TwinOutcome::kPutBack) {
      desk.flies = asked == Ask::kOut;
    }
    desk.outcome = outcome;
    desk.asked = Ask::kNothing;  // last: whoever sees this sees the outcome
  }
}

bool TwinHal::Twins::locate(const Robot& robot, Time now, Vector& place, Vector& velocity) const noexcept {
  const RealPose& real = robot.real;
  if (!real.valid || real.stamp < now - config_.most_age) {
    return false;
  }
  velocity = vector(real.vx, real.vy, real.vz);
  place = vector(real.x, real.y, real.z);
  if (now > real.stamp) {
    place += to_seconds(now - real.stamp) * velocity;
  }
  return place.allFinite() && velocity.allFinite();
}

TwinOutcome TwinHal::Twins::take_out(Robot& robot, Time now) noexcept {
  Vector place, velocity;
  if (!locate(robot, now, place, velocity)) {
    return TwinOutcome::kNoPose;
  }
  robot.place = place;
  // Who was told something has the velocity of what it was told; else what it has.
  robot.velocity = robot.told ? robot.velocity : velocity;
  return TwinOutcome::kTakenOut;
}

TwinOutcome TwinHal::Twins::put_back(const Robot& robot, Desk& desk, Time now) noexcept {
  Vector place, velocity;
  if (!locate(robot, now, place, velocity)) {
    return TwinOutcome::kNoPose;
  }
  desk.distance = static_cast<float>((place - robot.place).norm());
  desk.speed = static_cast<float>((velocity - robot.velocity).norm());
  if (desk.distance > config_.most_distance) {
    return TwinOutcome::kTooFar;
  }
  return desk.speed > config_.most_speed ? TwinOutcome::kTooFast : TwinOutcome::kPutBack;
}

void TwinHal::Twins::show(Time now, const StateColumns& states) const noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    if (!desks_[r].flies.load(std::memory_order_relaxed)) {
      continue;
    }
    const Robot& robot = robots_[r];
    states.x[r] = static_cast<float>(robot.place[0]);
    states.y[r] = static_cast<float>(robot.place[1]);
    states.z[r] = static_cast<float>(robot.place[2]);
    states.vx[r] = static_cast<float>(robot.velocity[0]);
    states.vy[r] = static_cast<float>(robot.velocity[1]);
    states.vz[r] = static_cast<float>(robot.velocity[2]);
    states.stamp[r] = now;
    states.valid[r] = 1;
    if (!states.telemetry.empty()) {
      states.telemetry[r] = {};  // the robot's own battery is nothing to its twin
      states.telemetry[r].heard = now;
    }
  }
}

std::span<const CommandKind> TwinHal::Twins::park(std::span<const CommandKind> kinds) noexcept {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    kinds_[r] = desks_[r].flies.load(std::memory_order_relaxed) ? config_.parked : kinds[r];
  }
  return kinds_;
}

}  // namespace mayfly
