#include "controller/governor/governor.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/finite.hpp"

namespace mayfly {
namespace {

// Relative; below it a command that exceeds a limit is taken for one that was rounded.
constexpr double kRounding = 1e-6;
// A robot that is said to start at more than this many times its speed limit is not believed, and holds.
constexpr double kBelievable = 10.0;
// Between braking (0) and what is wanted (1), in the order in which they are tried.
constexpr double kShares[] = {1.0, 0.5, 0.25};

glm::vec3 at(std::span<const float> x, std::span<const float> y, std::span<const float> z, std::size_t i) {
  return {x[i], y[i], z[i]};
}

}  // namespace

Result<Governor> Governor::make(GovernorConfig config) {
  if (auto ok = check(config); !ok) {
    return fail(ok.error());
  }
  return Governor(std::move(config));
}

Governor::Governor(GovernorConfig config) : config_(std::move(config)), period_(to_seconds(config_.period)) {
  const auto low = glm::dvec3(config_.fence.min);
  const auto high = glm::dvec3(config_.fence.max);
  // Positions arrive as floats: what this can shift is kept besides.
  const double rounding = kRounding * (1.0 + glm::length(low) + glm::length(high));
  for (const GovernorGroup& spec : config_.groups) {
    const GovernorLimits& limits = spec.limits;
    const double kept = static_cast<double>(limits.radius) + limits.tube;
    const double change = limits.acceleration * period_;
    Group group;
    group.spec = spec;
    group.brake_step = limits.braking * period_;
    group.change_limit = change;
    group.fence_low = low + (kept + rounding);
    group.fence_high = high - (kept + rounding);
    // A tenth of the body, and what a tick's path may leave its chord by: the robot must be able to start
    // again.
    group.clearance = {kept, std::max(0.1 * limits.radius, 1e-3) + 0.625 * period_ * change};
    groups_.push_back(group);
  }
  const std::size_t agents = groups_.empty() ? 0 : config_.groups.back().first + config_.groups.back().count;
  reference_.resize(agents);
}

void Governor::govern(Time now, const GovernorState& state, const DesiredColumns& desired,
                      const GovernedColumns& out) noexcept {
  ++counters_.ticks;
  if (!fits(state, desired, out)) {
    ++counters_.refused_calls;
    std::fill(out.kind.begin(), out.kind.end(), CommandKind::kHold);
    return;
  }
  for (const Group& group : groups_) {
    for (std::size_t i = group.spec.first; i < group.spec.first + group.spec.count; ++i) {
      const Decision decision = decide(group, i, now, state, at(desired.vx, desired.vy, desired.vz, i));
      const auto command = glm::vec3(decision.command);
      reference_[i].velocity = command;
      out.kind[i] = decision.hold ? CommandKind::kHold : CommandKind::kVelocity;
      out.vx[i] = command.x;
      out.vy[i] = command.y;
      out.vz[i] = command.z;
      count(decision);
    }
  }
}

bool Governor::fits(const GovernorState& state, const DesiredColumns& desired,
                    const GovernedColumns& out) const noexcept {
  const std::size_t least =
      std::min({state.x.size(), state.y.size(), state.z.size(), state.vx.size(), state.vy.size(),
                state.vz.size(), state.stamp.size(), state.valid.size(), desired.vx.size(), desired.vy.size(),
                desired.vz.size(), out.kind.size(), out.vx.size(), out.vy.size(), out.vz.size()});
  return least >= agents();
}

Governor::Decision Governor::decide(const Group& group, std::size_t agent, Time now,
                                    const GovernorState& state, glm::vec3 desired) noexcept {
  Decision decision;
  Reference& reference = reference_[agent];
  const glm::vec3 measured = at(state.vx, state.vy, state.vz, agent);
  bool known = check_state(agent, now, state, decision);
  if (known && !reference.known &&
      !(glm::length(glm::dvec3(measured)) <= kBelievable * group.spec.limits.speed)) {
    decision.add(GovernorReason::kInvalidState);
    known = false;
  }
  if (known && !reference.known) {
    reference = {measured, true};
  }
  const auto velocity = glm::dvec3(reference.velocity);
  const bool commanded = finite(desired);
  if (!commanded) {
    decision.add(GovernorReason::kNotFinite);
  }
  if (!known || !commanded) {
    decision.command = brake(velocity, group.brake_step);
    decision.hold = !known && decision.command == glm::dvec3(0.0);
    return decision;
  }
  decision.command = limit(group, velocity, glm::dvec3(desired), decision);
  if (group.spec.enabled) {
    const glm::dvec3 position = glm::dvec3(at(state.x, state.y, state.z, agent)) +
                                static_cast<double>(group.spec.limits.response_time) * glm::dvec3(measured);
    decision.command = reserve_free(group, position, velocity, decision.command, decision);
  }
  return decision;
}

bool Governor::check_state(std::size_t agent, Time now, const GovernorState& state,
                           Decision& decision) const noexcept {
  if (state.valid[agent] == 0 || !finite(at(state.x, state.y, state.z, agent)) ||
      !finite(at(state.vx, state.vy, state.vz, agent))) {
    decision.add(GovernorReason::kInvalidState);
    return false;
  }
  const Time stamp = state.stamp[agent];
  // A stamp from the future would never grow old.
  if (stamp < now - config_.max_state_age || stamp > now + config_.max_state_age) {
    decision.add(GovernorReason::kStaleState);
    return false;
  }
  return true;
}

// Speed first, then the change of velocity: an agent that is too fast brakes along its way until it is legal,
// because a faster cut would break the acceleration limit.
glm::dvec3 Governor::limit(const Group& group, glm::dvec3 reference, glm::dvec3 desired,
                           Decision& decision) const noexcept {
  const double allowed = group.spec.limits.speed;
  const double slack = kRounding * allowed;
  glm::dvec3 wanted = desired;
  const double speed = glm::length(desired);
  if (speed > allowed + slack) {
    decision.add(GovernorReason::kSpeed);
    wanted *= allowed / speed;
  }
  if (!group.spec.enabled) {
    return wanted;
  }
  if (glm::length(reference) > allowed + slack) {
    const glm::dvec3 braking = brake(reference, group.brake_step);
    if (glm::length(braking - desired) > slack) {
      decision.add(GovernorReason::kSpeed);
    }
    return braking;
  }
  const glm::dvec3 change = wanted - reference;
  const double size = glm::length(change);
  if (size > group.change_limit + slack) {
    decision.add(GovernorReason::kAcceleration);
  }
  return size > group.change_limit ? reference + change * (group.change_limit / size) : wanted;
}

// All that is tried lies between two velocities that keep both limits, and both limits are balls: so does
// everything here.
glm::dvec3 Governor::reserve_free(const Group& group, glm::dvec3 position, glm::dvec3 reference,
                                  glm::dvec3 wanted, Decision& decision) const noexcept {
  const glm::dvec3 braking = brake(reference, group.brake_step);
  const glm::dvec3 beyond = wanted - braking;
  // What stood in the way of the command as it was wanted.
  GovernorReason first_cause = GovernorReason::kFence;
  for (const double share : kShares) {
    const glm::dvec3 command = share == 1.0 ? wanted : braking + share * beyond;
    GovernorReason cause = GovernorReason::kFence;
    const Reservation reservation = reserve(position, reference, command, group.spec.limits.braking, period_);
    if (admissible(group, reservation, cause)) {
      if (share != 1.0) {
        decision.add(first_cause);
      }
      return command;
    }
    first_cause = share == 1.0 ? cause : first_cause;
  }
  if (glm::length(beyond) > kRounding * group.spec.limits.speed) {
    decision.add(first_cause);
  }
  return braking;
}

// Distance to the other agents' reservations belongs here too, once it is governed.
bool Governor::admissible(const Group& group, const Reservation& reservation,
                          GovernorReason& obstacle) const noexcept {
  if (!inside_fence(reservation, group.fence_low, group.fence_high)) {
    obstacle = GovernorReason::kFence;
    return false;
  }
  if (!config_.obstacles.empty() && !clear_of_obstacles(reservation, config_.obstacles, group.clearance)) {
    obstacle = GovernorReason::kObstacle;
    return false;
  }
  return true;
}

void Governor::count(const Decision& decision) noexcept {
  if (decision.reasons == 0) {
    return;
  }
  ++counters_.interventions;
  for (std::size_t reason = 0; reason < kGovernorReasons; ++reason) {
    counters_.by_reason[reason] += (decision.reasons >> reason) & 1U;
  }
}

}  // namespace mayfly
