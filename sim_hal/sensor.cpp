#include "sim_hal/sensor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim_hal/random.hpp"

namespace mayfly::sim_hal {

namespace {

constexpr Time kGhostTurn = std::chrono::milliseconds(30);

std::array<std::span<float>, 6> columns_of(const StateColumns& s) {
  return {s.x, s.y, s.z, s.vx, s.vy, s.vz};
}

void count(std::atomic<std::uint64_t>& counter, std::uint64_t how_many = 1) noexcept {
  counter.fetch_add(how_many, std::memory_order_relaxed);
}

std::optional<PoseRing> make_past(std::size_t robots, float delay, double rate_hz) {
  if (delay <= 0.0F) {
    return std::nullopt;
  }
  // A step is kept once, so no more than this can be younger than the delay.
  return PoseRing(static_cast<std::size_t>(std::ceil(static_cast<double>(delay) * rate_hz)) + 2, robots);
}

}  // namespace

Sensor::Sensor(std::size_t robots, const Faults& faults, std::uint64_t seed, double rate_hz,
               const FaultScript& script)
    : faults_(faults),
      script_(&script),
      seed_(seed),
      past_(make_past(robots, faults.delay, rate_hz)),
      was_told_(faults.freeze > 0.0F ? robots : 0),
      told_(faults.freeze > 0.0F ? robots : 0),
      held_(script.has(Effect::kPoseFrozen) ? robots : 0) {}

void Sensor::restart() noexcept {
  if (past_) {
    past_->clear();
  }
  std::fill(was_told_.begin(), was_told_.end(), std::uint8_t{0});
}

void Sensor::deliver(Time now, Time since_start, const PoseView& newest,
                     const StateColumns& states) noexcept {
  measure(now, newest, states);
  if (!script_->empty()) {
    follow_script(since_start, states);
  }
}

// The worst last, so that of several faults at once none is hidden by a milder one.
void Sensor::follow_script(Time since_start, const StateColumns& states) noexcept {
  const auto columns = columns_of(states);
  script_->each(Effect::kIdSwap, [&](const ScriptedFault& fault) {
    const RobotIndex a = fault.robot(0);
    const RobotIndex b = fault.robot(1);
    if (!fault.is_on(since_start) || a == kEveryRobot || b == kEveryRobot) {
      return;
    }
    for (const auto& column : columns) {
      std::swap(column[a], column[b]);
    }
    std::swap(states.valid[a], states.valid[b]);
  });
  script_->each_robot(Effect::kPoseJump, since_start, [&](RobotIndex robot, const ScriptedFault& fault) {
    for (int axis = 0; axis < 3; ++axis) {
      columns[static_cast<std::size_t>(axis)][robot] += fault.size * fault.direction[axis];
    }
  });
  script_->each_robot(Effect::kPoseGhost, since_start, [&](RobotIndex robot, const ScriptedFault& fault) {
    const bool is_ghost = ((since_start - fault.from) / kGhostTurn) % 2 == 0;
    for (int axis = 0; axis < 3 && is_ghost; ++axis) {
      columns[static_cast<std::size_t>(axis)][robot] += fault.size * fault.direction[axis];
    }
  });
  freeze_by_script(since_start, states);
  script_->each_robot(Effect::kPoseNan, since_start, [&](RobotIndex robot, const ScriptedFault&) {
    for (const auto& column : columns) {
      column[robot] = std::numeric_limits<float>::quiet_NaN();
    }
    count(counters_.nans);
  });
  script_->each_robot(Effect::kPoseStale, since_start, [&](RobotIndex robot, const ScriptedFault&) {
    states.valid[robot] = 0;
    count(counters_.dropped);
  });
}

void Sensor::freeze_by_script(Time since_start, const StateColumns& states) noexcept {
  const auto columns = columns_of(states);
  script_->each(Effect::kPoseFrozen, [&](const ScriptedFault& fault) {
    const bool on = fault.is_on(since_start);
    for (std::size_t i = 0; fault.robot(i) != kEveryRobot; ++i) {
      const RobotIndex robot = fault.robot(i);
      for (std::size_t c = 0; c < 6; ++c) {
        float& kept = held_.column(c)[robot];
        (on ? columns[c][robot] : kept) = on ? kept : columns[c][robot];
      }
      count(counters_.frozen, on ? 1 : 0);
    }
  });
}

void Sensor::measure(Time now, const PoseView& newest, const StateColumns& states) noexcept {
  PoseView sample = newest;
  const std::size_t robots = states.x.size();
  if (past_) {
    past_->push(newest);
    sample = past_->newest_at(now - from_seconds(static_cast<double>(faults_.delay)));
    count(sample.step < 0 ? counters_.withheld : counters_.delayed, robots);
  }
  if (sample.step < 0) {
    std::fill(states.valid.begin(), states.valid.end(), std::uint8_t{0});
    return;
  }
  if (any_per_robot()) {
    for (std::uint32_t robot = 0; robot < robots; ++robot) {
      deliver_robot(robot, sample, states);
    }
    return;
  }
  for (std::size_t c = 0; c < 6; ++c) {
    std::copy(sample.columns[c].begin(), sample.columns[c].end(), columns_of(states)[c].begin());
  }
  std::fill(states.stamp.begin(), states.stamp.end(), sample.stamp);
  std::fill(states.valid.begin(), states.valid.end(), std::uint8_t{1});
}

bool Sensor::any_per_robot() const noexcept {
  return faults_.pose_noise > 0.0F || faults_.dropout > 0.0F || faults_.freeze > 0.0F || faults_.nan > 0.0F;
}

void Sensor::deliver_robot(std::uint32_t robot, const PoseView& sample, const StateColumns& states) noexcept {
  const auto chances = draw(seed_, robot, sample.step, Draw::kLoss);
  if (unit(chances[0]) < static_cast<double>(faults_.dropout)) {
    states.valid[robot] = 0;
    count(counters_.dropped);
    return;
  }
  states.valid[robot] = 1;
  states.stamp[robot] = sample.stamp;
  const auto columns = columns_of(states);
  if (!was_told_.empty() && was_told_[robot] != 0 && is_frozen(robot, sample.stamp)) {
    for (std::size_t c = 0; c < 6; ++c) {
      columns[c][robot] = told_.column(c)[robot];
    }
    count(counters_.frozen);
  } else {
    for (std::size_t c = 0; c < 6; ++c) {
      columns[c][robot] = sample.columns[c][robot];
    }
    add_noise(robot, sample.step, states);
    for (std::size_t c = 0; c < 6 && !was_told_.empty(); ++c) {
      told_.column(c)[robot] = columns[c][robot];
      was_told_[robot] = 1;
    }
  }
  if (unit(chances[1]) < static_cast<double>(faults_.nan)) {
    for (const auto& column : columns) {
      column[robot] = std::numeric_limits<float>::quiet_NaN();
    }
    count(counters_.nans);
  }
}

// A freeze that begins in some second begins at a random instant of it. Looked up, not remembered: so it does
// not depend on when, or how often, somebody reads.
bool Sensor::is_frozen(std::uint32_t robot, Time when) const noexcept {
  const double now = to_seconds(when);
  const auto length = static_cast<double>(faults_.freeze_time);
  const auto last = static_cast<std::int64_t>(std::floor(now));
  for (auto second = static_cast<std::int64_t>(std::floor(now - length)); second <= last; ++second) {
    const auto chances = draw(seed_, robot, second, Draw::kFreeze);
    if (unit(chances[0]) >= static_cast<double>(faults_.freeze)) {
      continue;
    }
    const double begin = static_cast<double>(second) + unit(chances[1]);
    if (now >= begin && now < begin + length) {
      return true;
    }
  }
  return false;
}

void Sensor::add_noise(std::uint32_t robot, std::int64_t step, const StateColumns& states) noexcept {
  if (faults_.pose_noise <= 0.0F) {
    return;
  }
  const auto bits = draw(seed_, robot, step, Draw::kNoise);
  const auto xy = normal(bits[0], bits[1]);
  const auto z = normal(bits[2], bits[3]);
  states.x[robot] += faults_.pose_noise * static_cast<float>(xy[0]);
  states.y[robot] += faults_.pose_noise * static_cast<float>(xy[1]);
  states.z[robot] += faults_.pose_noise * static_cast<float>(z[0]);
  count(counters_.noisy);
}

}  // namespace mayfly::sim_hal
