#include "simulate/breach_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mayfly::simulate {
namespace {

// Rounding of places and commands to floats, a few metres and metres a second from 0.
constexpr double kRounding = 1e-5;
// m: two that start too near rest first; how far they get meanwhile is rounding as well.
constexpr double kRest = 1e-4;

}  // namespace

Promise promise_of(const Scenario& scenario) {
  Promise promise;
  promise.fence = scenario.world.bounds;
  promise.planes = scenario.world.fence;
  for (const SwarmSpec& swarm : scenario.swarms) {
    promise.robots.insert(promise.robots.end(), static_cast<std::size_t>(swarm.count),
                          {swarm.radius, swarm.limits.speed, swarm.limits.acceleration, swarm.governor});
  }
  return promise;
}

BreachWatch::BreachWatch(Promise promise)
    : promise_(std::move(promise)),
      may_be_out_(promise_.robots.size()),
      may_be_nearer_(promise_.robots.size() * promise_.robots.size()),
      told_(promise_.robots.size()) {}

void BreachWatch::count(Breach breach, Time at, std::size_t first, std::size_t second) noexcept {
  ++breaches_[static_cast<std::size_t>(breach)];
  incidents_.push_back({at, breach, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second)});
}

// m by which the body is outside at most; negative inside.
double BreachWatch::outside(const sim_hal::PoseView& truth, std::size_t robot) const noexcept {
  const auto& p = truth.columns;
  const auto radius = static_cast<double>(promise_.robots[robot].radius);
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<double>(p[axis][robot]);
    const double low = static_cast<double>(promise_.fence.min[static_cast<int>(axis)]) + radius - at;
    const double high = at - static_cast<double>(promise_.fence.max[static_cast<int>(axis)]) + radius;
    if (std::isnan(at)) {
      return at;
    }
    most = std::max({most, low, high});
  }
  for (const PlaneSpec& plane : promise_.planes) {
    double along = radius - static_cast<double>(plane.offset);
    for (int axis = 0; axis < 3; ++axis) {
      along += static_cast<double>(plane.normal[axis]) *
               static_cast<double>(p[static_cast<std::size_t>(axis)][robot]);
    }
    most = std::max(most, along);
  }
  return most;
}

void BreachWatch::check_pair(const sim_hal::PoseView& truth, std::size_t i, std::size_t j) noexcept {
  const auto& p = truth.columns;
  const auto along = [&](std::size_t axis) {
    return static_cast<double>(p[axis][i]) - static_cast<double>(p[axis][j]);
  };
  const double gap = std::hypot(along(0), along(1), along(2)) -
                     static_cast<double>(promise_.robots[i].radius) -
                     static_cast<double>(promise_.robots[j].radius);
  double& nearer = may_be_nearer_[i * promise_.robots.size() + j];
  if (!has_begun_) {
    nearer = std::max(0.0, -gap) + (gap < 0.0 ? kRest : 0.0);
  }
  if (gap >= 0.0) {
    nearer = 0.0;
  }
  if (nearer == 0.0) {
    least_gap_ = std::min(least_gap_, gap);
  }
  if (!(gap >= -nearer - kRounding)) {
    count(Breach::kSeparation, truth.stamp, i, j);
  }
}

void BreachWatch::on_step(const sim_hal::PoseView& truth) noexcept {
  for (std::size_t i = 0; i < promise_.robots.size(); ++i) {
    if (!promise_.robots[i].governed) {
      continue;
    }
    const double out = outside(truth, i);
    double& may = may_be_out_[i];
    if (!has_begun_ && out > 0.0) {
      may = out + kRest;
    }
    if (!(out <= may + kRounding)) {
      count(Breach::kFence, truth.stamp, i, i);
    }
    may = out <= 0.0 ? 0.0 : may;
    for (std::size_t j = i + 1; j < promise_.robots.size(); ++j) {
      if (promise_.robots[j].governed) {
        check_pair(truth, i, j);
      }
    }
  }
  has_begun_ = true;
}

void BreachWatch::on_command(Time now, const CommandColumns& commands) noexcept {
  const double passed = last_ ? to_seconds(now - *last_) : 0.0;
  for (std::size_t i = 0; i < promise_.robots.size(); ++i) {
    const PromisedLimits& limits = promise_.robots[i];
    if (!limits.governed) {
      continue;
    }
    Told told;
    told.was_velocity = commands.kind[i] == CommandKind::kVelocity;
    if (told.was_velocity) {
      told.velocity = {static_cast<double>(commands.vx[i]), static_cast<double>(commands.vy[i]),
                       static_cast<double>(commands.vz[i])};
    }
    const auto& now_told = told.velocity;
    const auto& before = told_[i].velocity;
    const double speed = std::hypot(now_told[0], now_told[1], now_told[2]);
    const double change =
        std::hypot(now_told[0] - before[0], now_told[1] - before[1], now_told[2] - before[2]);
    if (!(speed <= static_cast<double>(limits.speed) + kRounding)) {
      count(Breach::kSpeed, now, i, i);
    }
    if (told.was_velocity && told_[i].was_velocity &&
        !(change <= static_cast<double>(limits.acceleration) * passed + kRounding)) {
      count(Breach::kAcceleration, now, i, i);
    }
    told_[i] = told;
  }
  last_ = now;
}

}  // namespace mayfly::simulate
