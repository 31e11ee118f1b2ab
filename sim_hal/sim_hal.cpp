#include "sim_hal/sim_hal.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "sim_hal/check.hpp"

namespace mayfly::sim_hal {

namespace {

constexpr std::string_view kThreadFailed = "OpenCL: the plants' thread has given up";

void translate(Time now, const CommandColumns& commands, PlantCommand& to) noexcept {
  std::copy(commands.kind.begin(), commands.kind.end(), to.kind.begin());
  std::copy(commands.vx.begin(), commands.vx.end(), to.x.begin());
  std::copy(commands.vy.begin(), commands.vy.end(), to.y.begin());
  std::copy(commands.vz.begin(), commands.vz.end(), to.z.begin());
  to.deadline = commands.deadline;
  to.sent = now;
}

}  // namespace

std::string link_name(const std::string& hal, int links, std::size_t robot, std::size_t robots) {
  const auto count = static_cast<std::size_t>(std::max(1, links));
  return count == 1 ? hal : hal + "/" + std::to_string(robot * count / std::max<std::size_t>(1, robots));
}

SimHal::SimHal(SimHalConfig config) : config_(std::move(config)), script_(config_.script) {}

Result<void> SimHal::do_configure() {
  if (auto checked = check(config_); !checked) {
    return checked;
  }
  const std::size_t robots = config_.positions.size();
  auto plants = PlantRun::create(config_, script_);
  if (!plants) {
    return fail(std::move(plants.error()));
  }
  plants_.emplace(std::move(*plants));
  sensor_ = std::make_unique<Sensor>(robots, config_.faults, config_.seed, config_.rate_hz, script_);
  if (config_.lock_step) {
    command_ = PlantCommand(robots);
  } else {
    thread_ = std::make_unique<PlantThread>(*plants_, *config_.clock, robots, config_.rate_hz);
  }
  infos_.clear();
  for (std::size_t robot = 0; robot < robots; ++robot) {
    infos_.push_back({config_.robot_names[robot], link_name(config_.name, config_.links, robot, robots)});
  }
  radio_ = std::make_unique<Radio>(infos_, config_.name, script_, config_.seed, config_.endurance);
  return {};
}

Result<void> SimHal::do_activate(Time now) {
  if (!started_) {
    started_ = true;
    origin_ = now;
  }
  plants_->resume(now);
  radio_->start(now);
  sensor_->restart();
  if (thread_) {
    thread_->start(now);
  }
  return {};
}

HalResult SimHal::do_read(Time now, const StateColumns& states) noexcept {
  const HalResult heard = radio_->poll(now);
  if (thread_) {
    thread_->poses().collect();
    const PoseView view = thread_->poses().latest().view();
    sensor_->deliver(now, now - origin_, view, states);
    radio_->tell(now, view.airborne, states.telemetry);
    return thread_->failed() ? failed(kThreadFailed) : heard;
  }
  const std::string_view failure = plants_->advance(now);
  const PoseView view = plants_->view();
  sensor_->deliver(now, now - origin_, view, states);
  radio_->tell(now, view.airborne, states.telemetry);
  return failure.empty() ? heard : failed(failure);
}

HalResult SimHal::do_write(Time now, const CommandColumns& commands) noexcept {
  PlantCommand& to = thread_ ? thread_->commands().draft() : command_;
  const HalResult sent = radio_->send(now, to.reaches, to.late);
  translate(now, commands, to);
  if (thread_) {
    thread_->commands().publish();
    return thread_->failed() ? failed(kThreadFailed) : sent;
  }
  const std::string_view failure = plants_->advance(now);
  plants_->command(to);
  if (config_.watcher != nullptr) {
    config_.watcher->on_command(now, commands);
  }
  return failure.empty() ? sent : failed(failure);
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
  return {HalFault::kGivenUp, kEveryRobot, config_.name, cause};
}

}  // namespace mayfly::sim_hal
