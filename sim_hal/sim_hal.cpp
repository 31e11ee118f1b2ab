#include "sim_hal/sim_hal.hpp"

#include <algorithm>
#include <utility>

#include "sim_hal/check.hpp"

namespace mayfly::sim_hal {

namespace {

constexpr std::string_view kLink = "sim";
constexpr std::string_view kThreadFailed = "OpenCL: the plants' thread has given up";

void translate(const CommandColumns& commands, VelocityCommand& to) noexcept {
  for (std::size_t robot = 0; robot < to.x.size(); ++robot) {
    const bool flies = commands.kind[robot] == CommandKind::kVelocity;
    to.x[robot] = flies ? commands.vx[robot] : 0.0F;
    to.y[robot] = flies ? commands.vy[robot] : 0.0F;
    to.z[robot] = flies ? commands.vz[robot] : 0.0F;
  }
  to.deadline = commands.deadline;
}

}  // namespace

SimHal::SimHal(SimHalConfig config) : config_(std::move(config)) {}

Result<void> SimHal::do_configure() {
  if (auto checked = check(config_); !checked) {
    return checked;
  }
  const std::size_t robots = config_.positions.size();
  auto plants = PlantRun::create(config_);
  if (!plants) {
    return fail(std::move(plants.error()));
  }
  plants_.emplace(std::move(*plants));
  sensor_ = std::make_unique<Sensor>(robots, config_.faults, config_.seed, config_.rate_hz);
  if (config_.lock_step) {
    command_ = VelocityCommand(robots);
  } else {
    thread_ = std::make_unique<PlantThread>(*plants_, *config_.clock, robots, config_.rate_hz);
  }
  for (const std::string& robot : config_.robot_names) {
    infos_.push_back({robot, std::string(kLink)});
  }
  return {};
}

Result<void> SimHal::do_activate(Time now) {
  plants_->resume(now);
  sensor_->restart();
  if (thread_) {
    thread_->start(now);
  }
  return {};
}

HalResult SimHal::do_read(Time now, const StateColumns& states) noexcept {
  if (thread_) {
    thread_->poses().collect();
    sensor_->deliver(now, thread_->poses().latest().view(), states);
    return thread_->failed() ? failed(kThreadFailed) : HalResult{};
  }
  const std::string_view failure = plants_->advance(now);
  sensor_->deliver(now, plants_->view(), states);
  return failure.empty() ? HalResult{} : failed(failure);
}

HalResult SimHal::do_write(Time now, const CommandColumns& commands) noexcept {
  if (thread_) {
    translate(commands, thread_->commands().draft());
    thread_->commands().publish();
    return thread_->failed() ? failed(kThreadFailed) : HalResult{};
  }
  const std::string_view failure = plants_->advance(now);
  translate(commands, command_);
  plants_->command(command_);
  return failure.empty() ? HalResult{} : failed(failure);
}

Result<void> SimHal::do_deactivate(Time now) {
  if (thread_) {
    thread_->stop();
  } else {
    plants_->advance(now);
  }
  plants_->hold();
  return {};
}

PoseView SimHal::truth() noexcept {
  return plants_ && !thread_ ? plants_->view() : PoseView{};
}

HalResult SimHal::failed(std::string_view cause) const noexcept {
  return {HalFault::kLinkDown, kEveryRobot, kLink, cause};
}

}  // namespace mayfly::sim_hal
