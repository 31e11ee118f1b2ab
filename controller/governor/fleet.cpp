#include "controller/governor/fleet.hpp"

#include <algorithm>
#include <cmath>

#include "core/finite.hpp"

namespace mayfly {
namespace {

// A robot that is said to be faster than this many times its speed limit when it is first seen is not
// believed.
constexpr double kBelievable = 10.0;
// s, within which it is forgotten that a reference was moved: a drift that leaves the tube in less is told.
constexpr double kSlipSeconds = 0.25;
// s: a deadline that is missed by less was kept.
constexpr double kSameTime = 1e-8;

std::vector<GroupModel> group_models(const GovernorConfig& config) {
  std::vector<GroupModel> groups;
  for (const GovernorGroup& spec : config.groups) {
    groups.push_back(make_group_model(spec, config));
  }
  return groups;
}

std::size_t agents_of(const GovernorConfig& config) {
  return config.groups.empty() ? 0 : config.groups.back().first + config.groups.back().count;
}

double usual_ball(const GovernorConfig& config) {
  double tallest = 1.0;
  double reach = 0.0;
  double kept = 0.0;
  for (const GroupModel& group : group_models(config)) {
    tallest = std::max(tallest, static_cast<double>(group.spec.limits.downwash));
    reach = std::max(reach, group.usual_reach());
    kept = std::max(kept, group.kept);
  }
  return (reach + kept * tallest) * 1.001;
}

}  // namespace

Fleet::Fleet(const GovernorConfig& config)
    : groups_(group_models(config)),
      ground_(static_cast<double>(config.fence.min.z)),
      claims_(agents_of(config)),
      balls_(agents_of(config)),
      cells_(agents_of(config), config.fence, usual_ball(config)) {
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    const GovernorGroup& spec = groups_[g].spec;
    tallest_ = std::max(tallest_, static_cast<double>(spec.limits.downwash));
    longest_rest_ = std::max(longest_rest_, groups_[g].rest_time(spec.limits.speed));
    for (std::size_t i = 0; i < spec.count; ++i) {
      robots_.emplace_back(spec.enabled ? spec.limits.latency : 0, g);
    }
  }
}

void Fleet::forget() noexcept {
  for (FleetRobot& robot : robots_) {
    robot.reference.forget();
    robot.coasts = false;
  }
}

glm::dvec3 Fleet::braked(std::size_t i) const noexcept {
  const Braking& braking = group_of(i).braking;
  return brake(glm::dvec3(robots_[i].sent), braking.deceleration * std::min(passed_, braking.period));
}

double Fleet::most_change(std::size_t i) const noexcept {
  const GroupModel& group = group_of(i);
  return group.change_limit * std::min(passed_ / group.braking.period, 1.0);
}

void Fleet::settle(const GovernorState& state, double passed) noexcept {
  passed_ = passed;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const glm::vec3 place(state.x[i], state.y[i], state.z[i]);
    const glm::vec3 velocity(state.vx[i], state.vy[i], state.vz[i]);
    robots_[i].estimated = state.known[i] != 0 && finite(place) && finite(velocity);
    robots_[i].estimate = robots_[i].estimated ? glm::dvec3(place) : glm::dvec3(0.0);
    robots_[i].velocity = robots_[i].estimated ? velocity : glm::vec3(0.0F);
    settle_robot(i, state.authority.empty() ? Authority::kGoverned : state.authority[i], velocity);
    measure(i, state.measured.empty() || state.measured[i] != 0, !state.anew.empty() && state.anew[i] != 0);
    balls_[i] = ball_of(i);
  }
  cells_.sort(balls_);
}

void Fleet::settle_robot(std::size_t i, Authority authority, glm::vec3 velocity) noexcept {
  FleetRobot& robot = robots_[i];
  const Authority before = robot.authority;
  robot.authority = authority;
  switch (authority) {
    case Authority::kAbsent:
      robot.reference.forget();
      robot.sent = glm::vec3(0.0F);
      claims_[i] = {};
      break;
    case Authority::kForeign:
      robot.reference.forget();
      robot.sent = glm::vec3(0.0F);
      settle_foreign(i, velocity);
      break;
    case Authority::kAtRest:
      robot.sent = glm::vec3(0.0F);
      robot.coasts = false;
      if (robot.estimated) {
        robot.reference.adopt(robot.estimate, robot.sent, group_of(i).model);
        reserve_braking(i);
      }
      break;
    case Authority::kSilent:
      // What it heard last it may still do; nothing that it is told from now on changes that.
      if (is_flown(before)) {
        settle_ours(i, true, velocity);
        coast(i);
      } else {
        robot.rests_in -= passed_;
      }
      break;
    case Authority::kGoverned:
    case Authority::kBraking:
      // Whoever lands is not where its reference was left.
      settle_ours(i, (is_flown(before) && !robot.descends) || before == Authority::kSilent, velocity);
      break;
    case Authority::kLanding:
      settle_ours(i, is_flown(before) || before == Authority::kSilent, velocity);
  }
}

void Fleet::settle_ours(std::size_t i, bool was_ours, glm::vec3 velocity) noexcept {
  FleetRobot& robot = robots_[i];
  const GroupModel& group = group_of(i);
  if (!was_ours) {
    robot.reference.forget();
    robot.coasts = false;
  }
  if (robot.coasts) {
    settle_coasting(i);
    return;
  }
  if (robot.reference.known()) {
    if (group.spec.enabled && passed_ > group.command_life + kSameTime && robot.sent != glm::vec3(0.0F)) {
      coast(i);
      settle_coasting(i);
      return;
    }
    robot.reference.advance(robot.sent, passed_, group.model);
  } else {
    robot.descends = false;
    robot.estimated =
        robot.estimated && length3(glm::dvec3(velocity)) <= kBelievable * group.spec.limits.speed;
    if (!robot.estimated) {
      return;
    }
    robot.reference.adopt(robot.estimate, velocity, group.model);
    robot.sent = velocity;
  }
  reserve_braking(i);
}

void Fleet::coast(std::size_t i) noexcept {
  FleetRobot& robot = robots_[i];
  if (robot.coasts || !robot.reference.known() || !group_of(i).spec.enabled) {
    return;
  }
  robot.coasts = true;
  robot.is_late = false;
  robot.rests_in = group_of(i).rest_time_unheard(length3(glm::dvec3(robot.sent)));
  robot.sent = glm::vec3(0.0F);
}

// Its claim stays as it was, until it is at rest and seen: then it is where the claim is nearest to where it
// is seen, so that what is reserved from then on lies in the claim.
void Fleet::settle_coasting(std::size_t i) noexcept {
  FleetRobot& robot = robots_[i];
  robot.rests_in -= passed_;
  if (robot.rests_in > 0.0 || !robot.estimated) {
    return;
  }
  robot.coasts = false;
  robot.reference.adopt(nearest_in(claims_[i].capsule, robot.estimate), robot.sent, group_of(i).model);
  reserve_braking(i);
}

// Between two measurements a robot is taken to be as far off its reference as it was at the first. What it
// may do beside its reference changes with each: it is reserved anew.
void Fleet::measure(std::size_t i, bool measured, bool anew) noexcept {
  FleetRobot& robot = robots_[i];
  const GroupModel& group = group_of(i);
  if (robot.slipped != glm::dvec3(0.0)) {
    robot.slipped *= std::exp(-passed_ / kSlipSeconds);
  }
  if (robot.descends) {
    return;  // on its own way, which the column below it holds
  }
  if (!is_flown(robot.authority) || !robot.reference.known()) {
    robot.off = robot.beyond = robot.slipped = glm::dvec3(0.0);
    robot.torn = robot.strays = false;
    return;
  }
  if (!robot.estimated || !measured) {
    return;
  }
  const double tube = group.spec.limits.tube;
  const bool strayed = robot.strays;
  robot.off = robot.coasts ? robot.estimate - nearest_in(claims_[i].capsule, robot.estimate)
                           : robot.reference.way_to(robot.estimate);
  const double off = length3(robot.off);
  const bool within = off <= tube || tube <= 0.0;
  robot.torn = (robot.torn || anew) && !within;
  robot.beyond = within ? glm::dvec3(0.0) : robot.off * (1.0 - tube / off);
  robot.strays = tube > 0.0 && (!within || length3(robot.off + robot.slipped) > tube);
  if (strayed || robot.strays) {
    reserve_braking(i);
  }
}

// A ball around the place where it was seen last, which grows until it is seen again.
void Fleet::settle_foreign(std::size_t i, glm::vec3 velocity) noexcept {
  const GroupModel& group = group_of(i);
  Claim& claim = claims_[i];
  if (!robots_[i].estimated) {
    claim.age += passed_;
    return;
  }
  claim = {.present = group.spec.enabled,
           .capsule = {robots_[i].estimate, robots_[i].estimate, 0.0},
           .kept = group.kept,
           .scale = 1.0 / static_cast<double>(group.spec.limits.downwash),
           .speed = length3(glm::dvec3(velocity)),
           .acceleration = group.spec.limits.acceleration};
}

void Fleet::reserve_braking(std::size_t i) noexcept {
  FleetRobot& robot = robots_[i];
  if (!group_of(i).spec.enabled || robot.coasts) {
    return;
  }
  const Braking& braking = group_of(i).braking;
  const glm::dvec3 sent(robot.sent);
  const double late = passed_ - braking.period;
  robot.is_late = (late - kSameTime) * length3(sent) > braking.watchdog * braking.step() &&
                  length3(sent) > braking.step();
  robot.braking = robot.is_late ? tail_of(i) : hull_of(i, braked(i));
  Braking alone = braking;  // it may not hear that it is to brake
  alone.watchdog = std::max(braking.watchdog - late, 0.0);
  const glm::dvec3 rest = robot.reference.lead() + way_to_rest(sent, alone);
  robot.braking.add(rest);
  if (robot.beyond != glm::dvec3(0.0)) {
    robot.braking.add(rest + robot.beyond);
  }
  if (robot.authority == Authority::kLanding && (robot.descends || robot.sent == glm::vec3(0.0F))) {
    for (glm::dvec3 below : {robot.reference.lead(), robot.reference.lead() + robot.beyond}) {
      below.z = std::min(below.z, ground_ + group_of(i).kept);
      robot.braking.add(below);
    }
  }
  claims_[i] = claim_of(i, robot.braking);
}

// Where it is and may be, without a command.
Hull Fleet::tail_of(std::size_t i) const noexcept {
  Hull hull;
  robots_[i].reference.add_tail(hull, group_of(i).model);
  hull.add(robots_[i].reference.lead());
  if (robots_[i].beyond != glm::dvec3(0.0)) {
    hull.add_shifted(robots_[i].beyond);
  }
  return hull;
}

Hull Fleet::hull_of(std::size_t i, glm::dvec3 command) const noexcept {
  const FleetRobot& robot = robots_[i];
  Hull hull;
  robot.reference.add_tail(hull, group_of(i).model);
  add_command(hull, robot.reference.lead(), glm::dvec3(robot.reference.velocity()), command,
              group_of(i).braking);
  if (robot.beyond != glm::dvec3(0.0)) {
    hull.add_shifted(robot.beyond);
  }
  return hull;
}

Claim Fleet::claim_of(std::size_t i, const Hull& hull) const noexcept {
  const GroupModel& group = group_of(i);
  const FleetRobot& robot = robots_[i];
  Claim claim{.present = true,
              .capsule = capsule_around(hull.points()),
              .kept = group.kept,
              .scale = 1.0 / static_cast<double>(group.spec.limits.downwash)};
  // One that does not go where it is told is not ours to promise for.
  if (robot.strays) {
    claim.speed = length3(glm::dvec3(robot.velocity));
    claim.acceleration = group.spec.limits.acceleration;
  }
  return claim;
}

NeighbourCells::Ball Fleet::ball_of(std::size_t i) const noexcept {
  const Claim& claim = claims_[i];
  if (!claim.present) {
    return {};
  }
  const GroupModel& group = group_of(i);
  const Reference& reference = robots_[i].reference;
  const double around = claim.kept * tallest_;
  if (is_flown(robots_[i].authority) && robots_[i].authority != Authority::kLanding && reference.known() &&
      !robots_[i].coasts) {
    const double speed = length3(glm::dvec3(reference.velocity()));
    const double reach = group.reach(speed, reference.tail_reach(group.model));
    return {reference.lead(),
            around + reach + length3(robots_[i].beyond) + tallest_ * reach_of(claim, longest_rest_)};
  }
  const Capsule& capsule = claim.capsule;
  return {capsule.a, around + capsule.radius + length3(capsule.b - capsule.a) +
                         tallest_ * reach_of(claim, longest_rest_)};
}

Nearness Fleet::nearness_of(std::size_t i, const Hull& hull, const Claim& claim, double speed) noexcept {
  const FleetRobot& robot = robots_[i];
  const Wish wish{claim, hull, robot.braking, robot.reference.lead(), group_of(i).rest_time(speed)};
  return nearness(wish, claims_[i], claims_, near(i));
}

// The claim of one at rest reaches to the ground already. One that is not governed asks nobody, nor one of
// which nobody ever knew where it was.
bool Fleet::may_descend(std::size_t i, Nearness nearness) noexcept {
  FleetRobot& robot = robots_[i];
  const bool rests = robot.sent == glm::vec3(0.0F) && !robot.coasts;
  robot.descends = robot.descends || (rests && nearness == Nearness::kApart);
  return robot.descends;
}

bool Fleet::keeps_clear(std::size_t i, const Hull& hull, const Claim& claim, double speed,
                        const KeptClear& place) const noexcept {
  if (place.robot == i || place.robot >= robots_.size()) {
    return true;
  }
  const FleetRobot& robot = robots_[i];
  const GroupModel& whose = group_of(place.robot);
  const Claim stands{.present = true,
                     .capsule = {glm::dvec3(place.from), glm::dvec3(place.to), 0.0},
                     .kept = whose.kept,
                     .scale = 1.0 / static_cast<double>(whose.spec.limits.downwash)};
  const std::uint32_t only = 0;
  const Wish wish{claim, hull, robot.braking, robot.reference.lead(), group_of(i).rest_time(speed)};
  return nearness(wish, claims_[i], {&stands, 1}, {&only, 1}) != Nearness::kTooNear;
}

void Fleet::shift(std::size_t i, glm::dvec3 way) noexcept {
  FleetRobot& robot = robots_[i];
  robot.reference.shift(way);
  robot.off -= way;
  robot.slipped += way;
  const double off = length3(robot.off);
  const double tube = group_of(i).spec.limits.tube;
  robot.beyond = off <= tube || tube <= 0.0 ? glm::dvec3(0.0) : robot.off * (1.0 - tube / off);
  reserve_braking(i);
}

}  // namespace mayfly
