#include "bench/faults/breach_watch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mayfly::bench {
namespace {

// Rounding of places and commands to floats, a few metres and metres a second from 0.
constexpr double kRounding = 1e-5;
constexpr double kStill = 1e-3;  // m/s
constexpr Time kForGood = std::chrono::milliseconds(500);

}  // namespace

BreachWatch::BreachWatch(std::size_t robots, const PromisedLimits& limits)
    : robots_(robots), limits_(limits), told_(robots), was_velocity_(robots) {}

void BreachWatch::count(Breach breach, Time at, std::size_t first, std::size_t second) noexcept {
  ++breaches_[static_cast<std::size_t>(breach)];
  incidents_.push_back({at, breach, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second)});
}

void BreachWatch::mix(float value) noexcept {
  hash_ = (hash_ ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211U;
}

void BreachWatch::on_step(const sim_hal::PoseView& truth) noexcept {
  const auto& p = truth.columns;
  const auto radius = static_cast<double>(limits_.radius);
  for (std::size_t i = 0; i < robots_; ++i) {
    bool inside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<double>(p[axis][i]);
      const auto low = static_cast<double>(limits_.fence.min[static_cast<int>(axis)]);
      const auto high = static_cast<double>(limits_.fence.max[static_cast<int>(axis)]);
      inside = inside && at >= low + radius - kRounding && at <= high - radius + kRounding;
      mix(p[axis][i]);
    }
    if (!inside) {
      count(Breach::kFence, truth.stamp, i, i);
    }
    for (std::size_t j = i + 1; j < robots_; ++j) {
      const double gap = std::hypot(static_cast<double>(p[0][i]) - static_cast<double>(p[0][j]),
                                    static_cast<double>(p[1][i]) - static_cast<double>(p[1][j]),
                                    static_cast<double>(p[2][i]) - static_cast<double>(p[2][j])) -
                         2.0 * radius;
      least_gap_ = std::min(least_gap_, gap);
      if (!(gap >= -kRounding)) {
        count(Breach::kSeparation, truth.stamp, i, j);
      }
    }
  }
}

void BreachWatch::on_command(Time now, const CommandColumns& commands) noexcept {
  first_ = first_.value_or(now);
  const double passed = last_ ? to_seconds(now - *last_) : 0.0;
  std::vector<std::uint8_t> moving(robots_);
  for (std::size_t i = 0; i < robots_; ++i) {
    const bool velocity = commands.kind[i] == CommandKind::kVelocity;
    std::array<double, 3> told{};
    if (velocity) {
      told = {static_cast<double>(commands.vx[i]), static_cast<double>(commands.vy[i]),
              static_cast<double>(commands.vz[i])};
    }
    const double speed = std::hypot(told[0], told[1], told[2]);
    const double change = std::hypot(told[0] - told_[i][0], told[1] - told_[i][1], told[2] - told_[i][2]);
    if (!(speed <= static_cast<double>(limits_.speed) + kRounding)) {
      count(Breach::kSpeed, now, i, i);
    }
    if (velocity && was_velocity_[i] != 0 &&
        !(change <= static_cast<double>(limits_.acceleration) * passed + kRounding)) {
      count(Breach::kAcceleration, now, i, i);
    }
    moving[i] = speed > kStill ? 1 : 0;
    told_[i] = told;
    was_velocity_[i] = velocity ? 1 : 0;
    mix(static_cast<float>(told[0]));
    mix(static_cast<float>(told[1]));
    mix(static_cast<float>(told[2]));
    mix(static_cast<float>(commands.kind[i]));
  }
  times_.push_back(now);
  is_moving_.push_back(std::move(moving));
  last_ = now;
}

std::optional<double> BreachWatch::stopped_after(std::size_t robot, Time at) const {
  std::optional<Time> since;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    const Time time = times_[k] - *first_;
    if (time < at) {
      continue;
    }
    if (is_moving_[k][robot] != 0) {
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

}  // namespace mayfly::bench
