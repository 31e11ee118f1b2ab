#include "controller/governor/fleet.hpp"

#include <algorithm>

#include "core/finite.hpp"

namespace mayfly {
namespace {

// A robot that is said to be faster than this many times its speed limit when it is first seen is not
// believed.
constexpr double kBelievable = 10.0;

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
  }
}

void Fleet::settle(const GovernorState& state, std::uint64_t ticks) noexcept {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const glm::vec3 place(state.x[i], state.y[i], state.z[i]);
    const glm::vec3 velocity(state.vx[i], state.vy[i], state.vz[i]);
    robots_[i].estimated = state.known[i] != 0 && finite(place) && finite(velocity);
    robots_[i].estimate = robots_[i].estimated ? glm::dvec3(place) : glm::dvec3(0.0);
    settle_robot(i, state.authority.empty() ? Authority::kGoverned : state.authority[i], velocity, ticks);
    balls_[i] = ball_of(i);
  }
  cells_.sort(balls_);
}

void Fleet::settle_robot(std::size_t i, Authority authority, glm::vec3 velocity,
                         std::uint64_t ticks) noexcept {
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
      settle_foreign(i, velocity, ticks);
      break;
    case Authority::kAtRest:
      robot.sent = glm::vec3(0.0F);
      if (robot.estimated) {
        robot.reference.adopt(robot.estimate, robot.sent, group_of(i).model);
        reserve_braking(i);
      }
      break;
    case Authority::kSilent:
      // What it heard last it may still do; nothing that it is told from now on changes that.
      if (is_flown(before)) {
        settle_ours(i, true, velocity, ticks);
      }
      robot.reference.set_velocity(robot.sent);
      break;
    case Authority::kGoverned:
    case Authority::kBraking:
      settle_ours(i, is_flown(before), velocity, ticks);
  }
}

void Fleet::settle_ours(std::size_t i, bool was_ours, glm::vec3 velocity, std::uint64_t ticks) noexcept {
  FleetRobot& robot = robots_[i];
  const GroupModel& group = group_of(i);
  if (!was_ours) {
    robot.reference.forget();
  }
  if (robot.reference.known()) {
    for (std::uint64_t tick = 0; tick < ticks; ++tick) {
      robot.reference.advance(robot.sent, group.model);
    }
  } else {
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

// A ball around the place where it was seen last, which grows until it is seen again.
void Fleet::settle_foreign(std::size_t i, glm::vec3 velocity, std::uint64_t ticks) noexcept {
  const GroupModel& group = group_of(i);
  Claim& claim = claims_[i];
  if (!robots_[i].estimated) {
    claim.age += group.braking.period * static_cast<double>(ticks);
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
  if (!group_of(i).spec.enabled) {
    return;
  }
  FleetRobot& robot = robots_[i];
  const Braking& braking = group_of(i).braking;
  const glm::dvec3 velocity(robot.reference.velocity());
  robot.braking = hull_of(i, brake(velocity, braking.step()));
  if (braking.watchdog > 0.0) {  // it may not hear that it is to brake
    robot.braking.add(robot.reference.lead() + way_to_rest(velocity, braking));
  }
  claims_[i] = claim_of(i, robot.braking);
}

Hull Fleet::hull_of(std::size_t i, glm::dvec3 command) const noexcept {
  const FleetRobot& robot = robots_[i];
  Hull hull;
  robot.reference.add_tail(hull, group_of(i).model);
  add_command(hull, robot.reference.lead(), glm::dvec3(robot.reference.velocity()), command,
              group_of(i).braking);
  return hull;
}

Claim Fleet::claim_of(std::size_t i, const Hull& hull) const noexcept {
  const GroupModel& group = group_of(i);
  return {.present = true,
          .capsule = capsule_around(hull.points()),
          .kept = group.kept,
          .scale = 1.0 / static_cast<double>(group.spec.limits.downwash)};
}

NeighbourCells::Ball Fleet::ball_of(std::size_t i) const noexcept {
  const Claim& claim = claims_[i];
  if (!claim.present) {
    return {};
  }
  const GroupModel& group = group_of(i);
  const Reference& reference = robots_[i].reference;
  const double around = claim.kept * tallest_;
  if (is_flown(robots_[i].authority) && reference.known()) {
    const double speed = length3(glm::dvec3(reference.velocity()));
    return {reference.lead(), around + group.reach(speed, reference.tail_reach(group.model))};
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

void Fleet::shift(std::size_t i, glm::dvec3 way) noexcept {
  robots_[i].reference.shift(way);
  reserve_braking(i);
}

}  // namespace mayfly
