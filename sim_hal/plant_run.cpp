#include "sim_hal/plant_run.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "kernels/plants.h"

namespace mayfly::sim_hal {

namespace {

constexpr float kVerticalSpeed = 0.5F;        // m/s, of a robot that lands or takes off by itself
constexpr std::size_t kMostOnTheirWay = 256;  // commands; those before are as good as lost
constexpr float kHover = 0.5F;                // m above the ground, where a take-off ends
// After so long every plant that holds has stopped, as far as a float can tell.
constexpr double kSettlingTime = 60.0;  // s

float limit_of(const std::vector<float>& limits, std::size_t robot) {
  if (limits.size() <= 1) {
    return limits.empty() ? std::numeric_limits<float>::infinity() : limits.front();
  }
  return limits[robot];
}

void fill_limits(std::span<float> column, const std::vector<float>& limits) {
  for (std::size_t robot = 0; robot < column.size(); ++robot) {
    column[robot] = limit_of(limits, robot);
  }
}

bool moves(const FaultScript& script) {
  return script.has(Effect::kWind) || script.has(Effect::kWeakMotor) || script.has(Effect::kLinkLatency);
}

}  // namespace

Result<PlantRun> PlantRun::create(const SimHalConfig& config, const FaultScript& script) {
  const std::size_t robots = config.positions.size();
  auto chosen = make_stepper(config.backend, robots, {config.plant, config.time_constant, config.rate_hz});
  if (!chosen) {
    return fail(std::move(chosen.error()));
  }
  const PlantBlock block = chosen->stepper->block();
  for (std::size_t robot = 0; robot < robots; ++robot) {
    const glm::vec3 at = config.positions[robot];
    block.column(MF_PLANT_X, robots)[robot] = at.x;
    block.column(MF_PLANT_X + 1, robots)[robot] = at.y;
    block.column(MF_PLANT_X + 2, robots)[robot] = at.z;
  }
  fill_limits(block.column(MF_PLANT_MAX_SPEED, robots), config.max_speed);
  fill_limits(block.column(MF_PLANT_MAX_ACCELERATION, robots), config.max_acceleration);
  return PlantRun(std::move(*chosen), config, script);
}

PlantRun::PlantRun(ChosenStepper chosen, const SimHalConfig& config, const FaultScript& script)
    : stepper_(std::move(chosen.stepper)),
      note_(std::move(chosen.note)),
      config_(&config),
      script_(&script),
      moved_by_script_(moves(script)),
      robots_(config.positions.size()),
      rate_hz_(config.rate_hz),
      told_(robots_),
      deadline_(robots_),
      heard_(robots_, Time::min()),
      airborne_(robots_, 1) {
  if (script.has(Effect::kLinkLatency)) {
    on_their_way_.assign(kMostOnTheirWay, PlantCommand(robots_));
    for (PlantCommand& command : on_their_way_) {
      std::fill(command.reaches.begin(), command.reaches.end(), std::uint8_t{0});
    }
  }
}

void PlantRun::resume(Time now) noexcept {
  if (!started_) {
    started_ = true;
    origin_ = now;
    steps_ = StepClock(now, rate_hz_);
    return;
  }
  const auto most = static_cast<std::int64_t>(kSettlingTime * rate_hz_);
  done_ = std::max(done_, steps_.steps_at(now) - most);
  hold();
  advance(now);
}

std::string_view PlantRun::advance(Time now) noexcept {
  const std::int64_t until = steps_.steps_at(now);
  while (done_ < until && failure_.empty()) {
    prepare_step();
    step(steps_ahead(until));
  }
  return failure_;
}

// Every robot obeys until its own deadline; wind and weak motors come on top.
void PlantRun::prepare_step() noexcept {
  const Time now = steps_.time_of(done_);
  script_->each(Effect::kSimulationFails, [&](const ScriptedFault& fault) {
    failure_ = now - origin_ >= fault.from ? "the simulation was told to fail" : failure_;
  });
  hear_late(now);
  if (!failure_.empty() || (!is_new_ && !moved_by_script_ && !self_moving_ && now < next_deadline_)) {
    return;
  }
  next_deadline_ = Time::max();
  self_moving_ = false;
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    tell_robot(robot, now);
  }
  is_new_ = false;
  if (moved_by_script_) {
    apply_script(now - origin_);
  }
}

void PlantRun::tell_robot(std::size_t robot, Time now) noexcept {
  const PlantBlock block = stepper_->block();
  const bool heeds = now < deadline_[robot];
  const CommandKind kind = heeds ? told_.kind[robot] : CommandKind::kHold;
  glm::vec3 u(0.0F);
  if (kind == CommandKind::kVelocity && airborne_[robot] != 0) {
    u = {told_.x[robot], told_.y[robot], told_.z[robot]};
  } else if (kind == CommandKind::kLand && airborne_[robot] != 0) {
    u.z = std::isfinite(config_->ground) ? -kVerticalSpeed : 0.0F;
  } else if (kind == CommandKind::kTakeOff &&
             block.column(MF_PLANT_X + 2, robots_)[robot] < config_->ground + kHover) {
    airborne_[robot] = 1;
    u.z = kVerticalSpeed;
  }
  for (int axis = 0; axis < 3; ++axis) {
    block.column(MF_PLANT_UX + axis, robots_)[robot] = u[axis];
  }
  self_moving_ = self_moving_ || kind == CommandKind::kLand || kind == CommandKind::kTakeOff;
  if (heeds) {
    next_deadline_ = std::min(next_deadline_, deadline_[robot]);
  }
}

void PlantRun::apply_script(Time since) noexcept {
  const PlantBlock block = stepper_->block();
  const auto speed = block.column(MF_PLANT_MAX_SPEED, robots_);
  const auto acceleration = block.column(MF_PLANT_MAX_ACCELERATION, robots_);
  fill_limits(speed, config_->max_speed);
  fill_limits(acceleration, config_->max_acceleration);
  script_->each_robot(Effect::kWeakMotor, since, [&](RobotIndex robot, const ScriptedFault& fault) {
    speed[robot] *= fault.size;
    acceleration[robot] *= fault.size;
  });
  script_->each_robot(Effect::kWind, since, [&](RobotIndex robot, const ScriptedFault& fault) {
    for (int axis = 0; axis < 3 && airborne_[robot] != 0; ++axis) {
      block.column(MF_PLANT_UX + axis, robots_)[robot] += fault.size * fault.direction[axis];
    }
  });
}

// How many steps may be taken before what the plants are told changes.
std::int64_t PlantRun::steps_ahead(std::int64_t until) const noexcept {
  if (moved_by_script_ || config_->watcher != nullptr || self_moving_) {
    return std::min<std::int64_t>(1, until - done_);
  }
  const std::int64_t most = next_deadline_ == Time::max() ? until : steps_.first_step_from(next_deadline_);
  return std::clamp<std::int64_t>(most - done_, 1, until - done_);
}

void PlantRun::step(std::int64_t count) noexcept {
  constexpr std::int64_t kMost = 1 << 20;  // one launch; the kernel counts in int
  while (count > 0 && failure_.empty()) {
    const std::int64_t now = std::min(count, kMost);
    failure_ = stepper_->step(static_cast<std::uint32_t>(now));
    count -= now;
    done_ += now;
  }
  if (self_moving_ && failure_.empty()) {
    land();
  }
  if (config_->watcher != nullptr && failure_.empty()) {
    config_->watcher->on_step(view());
  }
}

// Who has reached the ground stays there, its motors off.
void PlantRun::land() noexcept {
  const PlantBlock block = stepper_->block();
  const auto z = block.column(MF_PLANT_X + 2, robots_);
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    if (airborne_[robot] == 0 || told_.kind[robot] != CommandKind::kLand || z[robot] > config_->ground) {
      continue;
    }
    z[robot] = config_->ground;
    airborne_[robot] = 0;
    for (int axis = 0; axis < 3; ++axis) {
      block.column(MF_PLANT_VX + axis, robots_)[robot] = 0.0F;
      block.column(MF_PLANT_UX + axis, robots_)[robot] = 0.0F;
    }
  }
}

void PlantRun::command(const PlantCommand& command) noexcept {
  if (!failure_.empty()) {
    return;
  }
  if (!on_their_way_.empty()) {
    newest_ = (newest_ + 1) % on_their_way_.size();
    on_their_way_[newest_] = command;
    hear_late(command.sent);
    return;
  }
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    if (command.reaches[robot] != 0) {
      hear(robot, command);
    }
  }
  is_new_ = true;
}

void PlantRun::hear(std::size_t robot, const PlantCommand& command) noexcept {
  told_.kind[robot] = command.kind[robot];
  told_.x[robot] = command.x[robot];
  told_.y[robot] = command.y[robot];
  told_.z[robot] = command.z[robot];
  deadline_[robot] = command.deadline;
}

// What is there by now, in the order in which it was sent: a robot heeds no command that is older than one it
// has heard.
void PlantRun::hear_late(Time now) noexcept {
  for (std::size_t i = 1; i <= on_their_way_.size(); ++i) {
    PlantCommand& command = on_their_way_[(newest_ + i) % on_their_way_.size()];
    for (std::size_t robot = 0; robot < robots_; ++robot) {
      if (command.reaches[robot] == 0 || now < command.sent + command.late[robot]) {
        continue;
      }
      command.reaches[robot] = 0;
      if (command.sent >= heard_[robot]) {
        heard_[robot] = command.sent;
        hear(robot, command);
        is_new_ = true;
      }
    }
  }
}

void PlantRun::hold() noexcept {
  std::fill(deadline_.begin(), deadline_.end(), Time::min());
  for (PlantCommand& command : on_their_way_) {
    std::fill(command.reaches.begin(), command.reaches.end(), std::uint8_t{0});
  }
  is_new_ = true;
}

PoseView PlantRun::view() noexcept {
  if (!failure_.empty()) {
    return {};
  }
  const PlantBlock block = stepper_->block();
  PoseView view{{}, airborne_, steps_.time_of(done_), done_};
  for (int c = 0; c < 6; ++c) {
    view.columns[static_cast<std::size_t>(c)] = block.column(MF_PLANT_X + c, robots_);
  }
  return view;
}

}  // namespace mayfly::sim_hal
