#include "controller/guard/monitor.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "controller/life_cycle/transitions.hpp"
#include "core/finite.hpp"

namespace mayfly {
namespace {

// Commands are floats, limits too: what their rounding can add, relative to the speed limit.
constexpr double kRounding = 1e-5;

glm::dvec3 velocity_of(const CommandColumns& c, std::size_t robot) noexcept {
  return c.kind[robot] == CommandKind::kVelocity ? glm::dvec3(c.vx[robot], c.vy[robot], c.vz[robot])
                                                 : glm::dvec3(0.0);
}

// Whether a robot may have got from one state to the other since the last tick: by one event; or all the way
// up, as one that is found in the air does when it is heard first.
bool may_follow(RobotState before, RobotState after) noexcept {
  if (before == after || (before < after && after <= RobotState::kFlying)) {
    return true;
  }
  for (std::size_t event = 0; event < kRobotEvents; ++event) {
    if (next_state(before, static_cast<RobotEvent>(event)) == after) {
      return true;
    }
  }
  return false;
}

}  // namespace

Monitor::Monitor(MonitorConfig config)
    : config_(std::move(config)),
      period_(to_seconds(config_.period)),
      separation_(config_.groups.empty() ? 0 : config_.groups.back().first + config_.groups.back().count),
      fence_(config_.fence, config_.half_spaces) {
  for (const GovernorGroup& group : config_.groups) {
    const GovernorLimits& l = group.limits;
    limits_.insert(
        limits_.end(), group.count,
        {l.speed, l.acceleration * period_, l.braking, l.radius, l.response_time, l.downwash, group.enabled});
  }
  const std::size_t robots = limits_.size();
  sent_.resize(robots);
  states_.resize(robots, RobotState::kUnknown);
  severities_.resize(robots, Severity::kNone);
  paths_.resize(robots);
  is_finite_.resize(robots, 1);
  symptoms_.resize(robots);
}

void Monitor::reset() noexcept {
  std::fill(sent_.begin(), sent_.end(), Sent{});
  std::fill(symptoms_.begin(), symptoms_.end(), Symptoms{});
  everybody_ = {};
  sequence_ = 0;
  has_begun_ = false;
  held_ = true;
  took_ = Time{0};
}

void Monitor::breach(Invariant invariant) noexcept {
  everybody_.add(symptom_of(invariant));
  ++counters_.breaches[static_cast<std::size_t>(invariant)];
  held_ = false;
}

void Monitor::breach(Invariant invariant, std::size_t robot) noexcept {
  symptoms_[robot].add(symptom_of(invariant));
  ++counters_.breaches[static_cast<std::size_t>(invariant)];
  held_ = false;
}

bool Monitor::has_one_each(const CommandColumns& c) const noexcept {
  const std::size_t robots = limits_.size();
  return c.kind.size() == robots && c.vx.size() == robots && c.vy.size() == robots && c.vz.size() == robots;
}

void Monitor::check(const TickOutcome& tick) noexcept {
  everybody_ = {};
  held_ = true;
  ++counters_.ticks;
  if (!has_one_each(tick.commands)) {
    breach(Invariant::kSequence);
    std::fill(is_finite_.begin(), is_finite_.end(), std::uint8_t{0});
    return;
  }
  for (std::size_t robot = 0; robot < limits_.size(); ++robot) {
    symptoms_[robot] = {};
    check_command(tick, robot);
    check_life(tick, robot);
  }
  check_space(tick);
  check_tick(tick);
  counters_.ticks_that_held += held_ ? 1U : 0U;
  has_begun_ = true;
}

void Monitor::check_command(const TickOutcome& tick, std::size_t robot) noexcept {
  const CommandKind kind = tick.commands.kind[robot];
  const glm::dvec3 velocity = velocity_of(tick.commands, robot);
  is_finite_[robot] = finite(velocity) ? 1 : 0;
  if (is_finite_[robot] == 0) {
    breach(Invariant::kFinite, robot);
    sent_[robot].known = false;
    return;
  }
  const Limits& limits = limits_[robot];
  const double speed = glm::length(velocity);
  if (speed > limits.speed * (1.0 + kRounding)) {
    breach(Invariant::kSpeed, robot);
  }
  const bool moves = speed > 0.0 || kind == CommandKind::kTakeOff || kind == CommandKind::kLand;
  if (moves && !is_armed(tick.states[robot])) {
    breach(Invariant::kArmed, robot);
  }
  const bool is_ours = limits.governed && tick.ours[robot] != 0;
  if (is_ours) {
    check_motion(tick, robot, velocity);
  }
  sent_[robot] = {velocity, is_ours};
}

// Nothing is known of what was sent before the first command: then any change will do.
void Monitor::check_motion(const TickOutcome& tick, std::size_t robot, const glm::dvec3& velocity) noexcept {
  const Limits& limits = limits_[robot];
  const Sent& before = sent_[robot];
  if (!before.known) {
    return;
  }
  const double slack = kRounding * limits.speed;
  // A robot that is told to hold brakes by itself.
  if (tick.commands.kind[robot] != CommandKind::kHold &&
      glm::length(velocity - before.velocity) > limits.change + slack) {
    breach(Invariant::kAcceleration, robot);
  }
  const bool is_faster = glm::length(velocity) > glm::length(before.velocity) + slack;
  if (tick.estimate.known[robot] == 0 && is_faster) {
    breach(Invariant::kAges, robot);
  }
  if (tick.governed[robot].has(Symptom::kTrackingError)) {
    breach(Invariant::kTracking, robot);
  }
}

void Monitor::check_life(const TickOutcome& tick, std::size_t robot) noexcept {
  if (has_begun_ && !tick.acknowledged && !may_follow(states_[robot], tick.states[robot])) {
    breach(Invariant::kTransition, robot);
  }
  const Severity before = severities_[robot];
  if (has_begun_ && !tick.acknowledged && before >= Severity::kHoldAll && tick.severities[robot] < before) {
    breach(Invariant::kSeverity, robot);
  }
  states_[robot] = tick.states[robot];
  severities_[robot] = tick.severities[robot];
}

// What it commands takes it to `lead`, which a lagging body follows; from there it brakes.
StoppingPath Monitor::path_of(const TickOutcome& tick, std::size_t robot) const noexcept {
  const Limits& limits = limits_[robot];
  const EstimateColumns& e = tick.estimate;
  StoppingPath path;
  path.radius = limits.radius;
  path.downwash = limits.downwash;
  path.counts = limits.governed && tick.ours[robot] != 0 && e.known[robot] != 0 && sent_[robot].known;
  if (!path.counts) {
    return path;
  }
  const glm::dvec3 velocity = sent_[robot].velocity;
  path.from = {e.x[robot], e.y[robot], e.z[robot]};
  const glm::dvec3 lead =
      path.from + limits.response_time * glm::dvec3(e.vx[robot], e.vy[robot], e.vz[robot]);
  path.to = lead + velocity * (glm::length(velocity) / (2.0 * limits.braking));
  return path;
}

void Monitor::check_space(const TickOutcome& tick) noexcept {
  for (std::size_t robot = 0; robot < paths_.size(); ++robot) {
    paths_[robot] = path_of(tick, robot);
    if (paths_[robot].counts && fence_.is_left_by(paths_[robot])) {
      breach(Invariant::kFence, robot);
    }
  }
  separation_.check(paths_, [this](std::uint32_t i, std::uint32_t j) {
    breach(Invariant::kSeparation, i);
    symptoms_[j].add(symptom_of(Invariant::kSeparation));
  });
}

void Monitor::check_tick(const TickOutcome& tick) noexcept {
  const CommandColumns& c = tick.commands;
  if (c.sequence <= sequence_) {
    breach(Invariant::kSequence);
  }
  sequence_ = c.sequence;
  if (c.deadline <= tick.now || c.deadline > tick.now + config_.most_command_life) {
    breach(Invariant::kAges);
  }
  if (config_.tick_budget > Time{0} && took_ > config_.tick_budget) {
    breach(Invariant::kTickBudget);
  }
  if (config_.hooks.allocations) {
    const std::uint64_t allocations = config_.hooks.allocations();
    if (has_begun_ && allocations != allocations_) {
      breach(Invariant::kNoAllocation);
    }
    allocations_ = allocations;
  }
  if (config_.hooks.owns_commands && !config_.hooks.owns_commands()) {
    breach(Invariant::kOneOwner);
  }
}

void Monitor::wrote(const HalResult& result) noexcept {
  if (result.fault != HalFault::kMisencoded) {
    return;
  }
  counters_.ticks_that_held -= held_ ? 1U : 0U;
  if (result.robot < symptoms_.size()) {
    breach(Invariant::kDecodes, result.robot);
  } else {
    breach(Invariant::kDecodes);
  }
}

}  // namespace mayfly
