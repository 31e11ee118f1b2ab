#include "bench/faults/command_watch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mayfly::bench {
namespace {

constexpr double kStill = 1e-3;       // m/s
constexpr double kSlow = 0.5 + 1e-5;  // m/s, at which a robot is brought down
constexpr double kBrakes = 0.5;       // of the acceleration: a robot may brake less hard than it can
constexpr Time kForGood = std::chrono::milliseconds(500);

}  // namespace

CommandWatch::CommandWatch(std::size_t robots, std::size_t ticks, double acceleration,
                           simulate::BreachWatch& breaches)
    : robots_(robots), acceleration_(acceleration), breaches_(breaches), speeds_(robots) {
  times_.reserve(ticks);
  moves_.reserve(ticks * robots);
  is_safe_.reserve(ticks * robots);
}

void CommandWatch::mix(float value) noexcept {
  hash_ = (hash_ ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211U;
}

void CommandWatch::on_step(const sim_hal::PoseView& truth) noexcept {
  breaches_.on_step(truth);
  for (std::size_t i = 0; i < robots_; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      mix(truth.columns[axis][i]);
    }
  }
}

void CommandWatch::on_command(Time now, const CommandColumns& commands) noexcept {
  breaches_.on_command(now, commands);
  const double passed = times_.empty() ? 0.0 : to_seconds(now - times_.back());
  for (std::size_t i = 0; i < robots_; ++i) {
    const bool velocity = commands.kind[i] == CommandKind::kVelocity;
    const float x = velocity ? commands.vx[i] : 0.0F;
    const float y = velocity ? commands.vy[i] : 0.0F;
    const float z = velocity ? commands.vz[i] : 0.0F;
    const double speed = std::hypot(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    const bool safe = !velocity || speed <= std::max(kSlow, speeds_[i] - kBrakes * acceleration_ * passed);
    moves_.push_back(speed > kStill ? 1 : 0);
    is_safe_.push_back(safe ? 1 : 0);
    speeds_[i] = speed;
    mix(x);
    mix(y);
    mix(z);
    mix(static_cast<float>(commands.kind[i]));
  }
  times_.push_back(now);
}

std::optional<double> CommandWatch::stopped_after(std::size_t robot, Time at) const {
  std::optional<Time> since;
  for (std::size_t tick = 0; tick < times_.size(); ++tick) {
    const Time time = times_[tick] - times_.front();
    if (time < at) {
      continue;
    }
    if (is(moves_, tick, robot)) {
      since.reset();
      continue;
    }
    since = since.value_or(time);
    if (time - *since >= kForGood) {
      break;
    }
  }
  return since ? std::optional(to_seconds(*since - at)) : std::nullopt;
}

std::optional<std::uint64_t> CommandWatch::safe_after(std::size_t robot, Time at) const {
  std::uint64_t commands = 0;
  for (std::size_t tick = 0; tick < times_.size(); ++tick) {
    if (times_[tick] - times_.front() < at) {
      continue;
    }
    if (is(is_safe_, tick, robot)) {
      return commands;
    }
    ++commands;
  }
  return std::nullopt;
}

}  // namespace mayfly::bench
