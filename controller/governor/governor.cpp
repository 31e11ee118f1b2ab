#include "controller/governor/governor.hpp"

#include <algorithm>
#include <utility>

#include "core/finite.hpp"

namespace mayfly {
namespace {

// Relative; below it a command that exceeds a limit is taken for one that was rounded.
constexpr double kRounding = 1e-6;
// Between braking (0) and what is wanted (1), in the order in which they are tried.
constexpr double kShares[] = {1.0, 0.5, 0.25};

bool columns_fit(std::size_t agents, const DesiredColumns& desired, const GovernedColumns& out) noexcept {
  const std::size_t least = std::min({desired.vx.size(), desired.vy.size(), desired.vz.size(),
                                      out.kind.size(), out.vx.size(), out.vy.size(), out.vz.size()});
  return least >= agents && (out.symptoms.empty() || out.symptoms.size() >= agents);
}

}  // namespace

Result<Governor> Governor::make(GovernorConfig config) {
  if (auto ok = check(config); !ok) {
    return fail(ok.error());
  }
  return Governor(std::move(config));
}

Governor::Governor(GovernorConfig config)
    : config_(std::move(config)), fence_(config_.fence, config_.half_spaces), fleet_(config_) {}

GovernorReference Governor::reference(std::size_t agent) const noexcept {
  const Reference& reference = fleet_.robot(agent).reference;
  return {reference.body(), glm::vec3(reference.velocity()), reference.known()};
}

void Governor::govern(Time now, const GovernorState& state, const DesiredColumns& desired,
                      const GovernedColumns& out) noexcept {
  ++counters_.ticks;
  const double passed = time_since_last(now);
  if (!columns_fit(agents(), state) || !columns_fit(agents(), desired, out)) {
    ++counters_.refused_calls;
    std::fill(out.kind.begin(), out.kind.end(), CommandKind::kHold);
    fleet_.forget();
    return;
  }
  kept_clear_ = state.kept_clear;
  fleet_.settle(state, passed);
  // Whoever comes first has the most room, so the first is another each tick.
  const std::size_t first = agents() == 0 ? 0 : counters_.ticks % agents();
  for (std::size_t n = 0; n < agents(); ++n) {
    const std::size_t i = first + n < agents() ? first + n : first + n - agents();
    nudge(i);
    const Decision decision = decide(i, {desired.vx[i], desired.vy[i], desired.vz[i]});
    tell(i, decision, out);
    if (!out.symptoms.empty()) {
      out.symptoms[i] = symptoms_of(i, decision);
    }
  }
}

// s. Before the first tick, and where a clock goes backwards, it is a period.
double Governor::time_since_last(Time now) noexcept {
  const Time before = std::exchange(last_, now);
  if (before == Time::min() || now <= before) {
    return to_seconds(config_.period);
  }
  const auto periods = (now - before + config_.period / 2) / config_.period;
  counters_.skipped_ticks += static_cast<std::uint64_t>(std::max<std::int64_t>(periods - 1, 0));
  return to_seconds(now - before);
}

Governor::Decision Governor::decide(std::size_t i, glm::vec3 desired) noexcept {
  Decision decision;
  const GroupModel& group = fleet_.group_of(i);
  const FleetRobot& robot = fleet_.robot(i);
  const bool moves = may_move(i, desired, decision);
  if (moves) {
    decision.command = limit(i, glm::dvec3(desired), decision);
    if (!group.spec.enabled || reserve_free(i, decision.command, decision)) {
      return decision;
    }
  }
  if (robot.is_late) {
    fleet_.coast(i);
  }
  decision.command = fleet_.braked(i);
  const bool ordered = robot.authority != Authority::kGoverned || !robot.estimated || robot.coasts;
  if (ordered && decision.command == glm::dvec3(0.0)) {
    decision.kind = robot.authority == Authority::kForeign ? CommandKind::kNone : CommandKind::kHold;
  }
  if (is_flown(robot.authority) && fleet_.claim(i).present && robot.reference.known()) {
    const double speed = length3(glm::dvec3(robot.sent));
    decision.nearness = fleet_.nearness_of(i, robot.braking, fleet_.claim(i), speed);
  }
  if (robot.authority == Authority::kLanding && fleet_.may_descend(i, decision.nearness)) {
    decision.kind = CommandKind::kLand;
  }
  return decision;
}

bool Governor::may_move(std::size_t i, glm::vec3 desired, Decision& decision) const noexcept {
  const FleetRobot& robot = fleet_.robot(i);
  switch (robot.authority) {
    case Authority::kGoverned:
      break;
    case Authority::kBraking:
    case Authority::kLanding:
    case Authority::kSilent:
      decision.add(GovernorReason::kOrdered);
      return false;
    case Authority::kAtRest:
    case Authority::kForeign:
    case Authority::kAbsent:
      return false;
  }
  if (!robot.estimated || robot.coasts) {
    decision.add(GovernorReason::kUnknown);
  }
  if (!finite(desired)) {
    decision.add(GovernorReason::kNotFinite);
  }
  return robot.estimated && !robot.coasts && finite(desired);
}

// Speed first, then the change of velocity: an agent that is too fast brakes along its way until it is legal,
// because a faster cut would break the acceleration limit.
glm::dvec3 Governor::limit(std::size_t i, glm::dvec3 desired, Decision& decision) const noexcept {
  const GroupModel& group = fleet_.group_of(i);
  const glm::dvec3 before(fleet_.robot(i).sent);
  const double allowed = group.spec.limits.speed;
  const double slack = kRounding * allowed;
  glm::dvec3 wanted = desired;
  const double speed = length3(desired);
  if (speed > allowed + slack) {
    decision.add(GovernorReason::kSpeed);
    wanted *= allowed / speed;
  }
  if (!group.spec.enabled) {
    return wanted;
  }
  if (length3(before) > allowed + slack) {
    const glm::dvec3 braking = fleet_.braked(i);
    if (length3(braking - desired) > slack) {
      decision.add(GovernorReason::kSpeed);
    }
    return braking;
  }
  const glm::dvec3 change = wanted - before;
  const double size = length3(change);
  const double most = fleet_.most_change(i);
  if (size > most + slack) {
    decision.add(GovernorReason::kAcceleration);
  }
  return size > most ? before + change * (most / size) : wanted;
}

// All that is tried lies between two velocities that keep both limits, and both limits are balls: so does
// everything here. False: only braking is left, or was wanted.
bool Governor::reserve_free(std::size_t i, glm::dvec3 wanted, Decision& decision) noexcept {
  const GroupModel& group = fleet_.group_of(i);
  const glm::dvec3 braking = fleet_.braked(i);
  const glm::dvec3 beyond = wanted - braking;
  if (length3(beyond) <= kRounding * group.spec.limits.speed) {
    return false;
  }
  // What stood in the way of the command as it was wanted.
  GovernorReason first_cause = GovernorReason::kFence;
  for (const double share : kShares) {
    const glm::dvec3 command = share == 1.0 ? wanted : braking + share * beyond;
    const Hull hull = fleet_.hull_of(i, command);
    const Trial trial{hull, fleet_.claim_of(i, hull), length3(command)};
    GovernorReason cause = GovernorReason::kFence;
    if (admissible(i, trial, decision, cause)) {
      decision.command = command;
      fleet_.reserve(i, trial.claim);
      if (share != 1.0) {
        decision.add(first_cause);
      }
      return true;
    }
    first_cause = share == 1.0 ? cause : first_cause;
  }
  decision.add(first_cause);
  return false;
}

bool Governor::admissible(std::size_t i, const Trial& trial, Decision& decision,
                          GovernorReason& cause) noexcept {
  cause = GovernorReason::kFence;
  if (!fence_.holds(trial.hull, fleet_.robot(i).braking, fleet_.group_of(i).kept)) {
    return false;
  }
  cause = GovernorReason::kNeighbour;
  const Nearness nearness = fleet_.nearness_of(i, trial.hull, trial.claim, trial.speed);
  if (nearness == Nearness::kTooNear || !clear_of_kept(i, trial)) {
    return false;
  }
  cause = GovernorReason::kObstacle;
  if (!clear_of_all(i, trial)) {
    return false;
  }
  decision.nearness = nearness;
  return true;
}

bool Governor::clear_of_all(std::size_t i, const Trial& trial) const noexcept {
  const Clearance clearance = fleet_.group_of(i).clearance;
  return config_.obstacles.empty() || clear_of_obstacles(trial.claim.capsule, config_.obstacles, clearance) ||
         leaves_obstacle(trial.hull, fleet_.robot(i).reference.lead(), trial.claim.capsule.radius,
                         config_.obstacles, clearance);
}

bool Governor::clear_of_kept(std::size_t i, const Trial& trial) const noexcept {
  return std::all_of(kept_clear_.begin(), kept_clear_.end(), [&](const KeptClear& place) {
    return fleet_.keeps_clear(i, trial.hull, trial.claim, trial.speed, place);
  });
}

// Moves a reference to where half the tube reaches the robot: no farther in a tick than it might have flown,
// and with a tube only to where its reservation is free. Without one nothing is promised of the difference.
// As far as the tube reaches it, it needs not ask: so far its claim goes already.
void Governor::nudge(std::size_t i) noexcept {
  const GroupModel& group = fleet_.group_of(i);
  const glm::dvec3 way = fleet_.robot(i).off;
  const double off = length3(way);
  if (!group.spec.enabled || off <= group.nudge_from || fleet_.robot(i).torn || fleet_.robot(i).coasts) {
    return;
  }
  if (const double beyond = length3(fleet_.robot(i).beyond); beyond > 0.0) {
    fleet_.shift(i, way * (std::min(beyond, group.most_nudge) / off));
    ++counters_.nudges;
    return;
  }
  const glm::dvec3 step = way * (std::min(off - group.nudge_from, group.most_nudge) / off);
  const Hull moved = fleet_.robot(i).braking.shifted(step);
  const double speed = length3(glm::dvec3(fleet_.robot(i).reference.velocity()));
  Decision unused;
  GovernorReason cause = GovernorReason::kFence;
  if (group.spec.limits.tube > 0.0F &&
      !admissible(i, {moved, fleet_.claim_of(i, moved), speed}, unused, cause)) {
    return;
  }
  fleet_.shift(i, step);
  ++counters_.nudges;
}

Symptoms Governor::symptoms_of(std::size_t i, const Decision& decision) const noexcept {
  const GovernorLimits& limits = fleet_.group_of(i).spec.limits;
  const FleetRobot& robot = fleet_.robot(i);
  Symptoms symptoms;
  if (!fleet_.group_of(i).spec.enabled || !is_flown(robot.authority)) {
    return symptoms;
  }
  if (robot.strays) {
    symptoms.add(Symptom::kTrackingError);
  }
  if (robot.estimated && fence_.depth(robot.estimate) < limits.radius - fleet_.group_of(i).nudge_from) {
    symptoms.add(Symptom::kOutOfFence);
  }
  if (decision.nearness != Nearness::kApart) {
    symptoms.add(Symptom::kTooNear);
  }
  if (decision.has(GovernorReason::kNotFinite)) {
    symptoms.add(Symptom::kCommandNotFinite);
  }
  return symptoms;
}

void Governor::tell(std::size_t i, const Decision& decision, const GovernedColumns& out) noexcept {
  const auto command = glm::vec3(decision.command);
  fleet_.robot(i).sent = command;
  out.kind[i] = decision.kind;
  out.vx[i] = command.x;
  out.vy[i] = command.y;
  out.vz[i] = command.z;
  if (decision.reasons == 0) {
    return;
  }
  ++counters_.interventions;
  for (std::size_t reason = 0; reason < kGovernorReasons; ++reason) {
    counters_.by_reason[reason] += (decision.reasons >> reason) & 1U;
  }
}

}  // namespace mayfly
