#include "controller/guard/orders.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace mayfly {
namespace {

// Of what is wished of a robot whose link is bad.
constexpr float kClampedShare = 0.5F;

const glm::vec3 kNowhere(std::numeric_limits<float>::quiet_NaN());
constexpr float kStayingRate = 2.0F;  // 1/s, of the way back to its place
constexpr float kMostAgainst = 1.0F;  // m/s: a drift that is faster is none, but a robot that does not answer
constexpr float kMostOfIt = 0.9F;     // of a wish: as good as all
constexpr float kFarthestBack = 0.3F;  // m: from farther away it does not go back, but stays there

// Of one that returns: the share of its way that it goes in a second, and where and how slow it has arrived.
constexpr float kHoming = 1.5F;    // 1/s
constexpr float kArrived = 0.02F;  // m
constexpr float kSlow = 0.06F;     // m/s

}  // namespace

Orders::Orders(Config config)
    : config_(std::move(config)),
      authority_(config_.robots, Authority::kBraking),
      ending_(config_.robots, Ending::kHold),
      vx_(config_.robots),
      vy_(config_.robots),
      vz_(config_.robots),
      ours_(config_.robots, 1),
      stays_(config_.robots, 1),
      places_(config_.robots, kNowhere),
      home_(config_.robots),
      destination_(config_.robots),
      lands_there_(config_.robots, 1) {}

void Orders::forget() noexcept {
  std::fill(home_.begin(), home_.end(), Place{});
  std::fill(destination_.begin(), destination_.end(), Place{});
}

void Orders::send_home(std::size_t robot) noexcept {
  destination_[robot] = home_[robot];
  lands_there_[robot] = 1;
}

void Orders::send_to(std::size_t robot, glm::vec3 place) noexcept {
  destination_[robot] = {place, true};
  lands_there_[robot] = 0;
}

void Orders::note_home(const Tick& tick, std::size_t robot) noexcept {
  const EstimateColumns& e = tick.estimate;
  const bool may_fly = is_armed(tick.lives.state(static_cast<RobotIndex>(robot)));
  if (!home_[robot].known && may_fly && e.known[robot] != 0) {
    home_[robot] = {{e.x[robot], e.y[robot], e.z[robot]}, true};
  }
}

void Orders::give(const Tick& tick) noexcept {
  for (std::size_t robot = 0; robot < authority_.size(); ++robot) {
    note_home(tick, robot);
    order(tick, robot);
  }
}

void Orders::set(std::size_t robot, Authority authority, Ending ending) noexcept {
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  authority_[robot] = authority;
  ending_[robot] = ending;
  ours_[robot] = authority == Authority::kAbsent || authority == Authority::kForeign ? 0 : 1;
  wish_of(robot, kNothing, kNothing, kNothing);
}

void Orders::wish_of(std::size_t robot, float x, float y, float z) noexcept {
  vx_[robot] = x;
  vy_[robot] = y;
  vz_[robot] = z;
}

// From the strongest word to the weakest.
void Orders::order(const Tick& tick, std::size_t robot) noexcept {
  const Severity severity = tick.severities[robot];
  const RobotState state = tick.lives.state(static_cast<RobotIndex>(robot));
  if (!tick.present.empty() && tick.present[robot] == 0) {
    set(robot, Authority::kAbsent, Ending::kHold);
  } else if (severity >= Severity::kCut) {
    set(robot, Authority::kForeign, Ending::kStop);
  } else if (!is_armed(state) || (severity < Severity::kHold && state != RobotState::kLanding)) {
    obey(tick, robot);
  } else if (severity >= Severity::kLand || state == RobotState::kLanding) {
    land(tick, robot);
  } else if (tick.symptoms[robot].has(Symptom::kSilent)) {
    set(robot, Authority::kSilent, Ending::kHold);
  } else {
    hold(tick, robot);
  }
}

// One that does not go where it is told would drift away if it were told to stand.
void Orders::hold(const Tick& tick, std::size_t robot) noexcept {
  if (!tick.symptoms[robot].has(Symptom::kTrackingError) || tick.estimate.known[robot] == 0) {
    set(robot, Authority::kBraking, Ending::kHold);
    return;
  }
  set(robot, Authority::kGoverned, Ending::kAsGoverned);
  const glm::vec3 wish = against_drift(tick, robot);
  wish_of(robot, wish.x, wish.y, wish.z);
}

// What keeps it in its place, as far as its speed reaches, m/s: through the governor like any other wish.
glm::vec3 Orders::against_drift(const Tick& tick, std::size_t robot) noexcept {
  const EstimateColumns& e = tick.estimate;
  if (!tick.symptoms[robot].has(Symptom::kTrackingError) || e.drift_x.empty()) {
    return glm::vec3(0.0F);
  }
  const glm::vec3 here(e.x[robot], e.y[robot], e.z[robot]);
  const glm::vec3 drift(e.drift_x[robot], e.drift_y[robot], e.drift_z[robot]);
  glm::vec3& place = places_[robot];
  if (!(glm::distance(place, here) <= kFarthestBack)) {
    place = here;
  }
  const glm::vec3 wish = kStayingRate * (place - here) - drift;
  const float speed = glm::length(wish);
  return speed > kMostAgainst ? wish * (kMostAgainst / speed) : wish;
}

void Orders::obey(const Tick& tick, std::size_t robot) noexcept {
  places_[robot] = kNowhere;
  switch (tick.lives.admit(static_cast<RobotIndex>(robot), tick.wish.kind(robot))) {
    case CommandKind::kVelocity: {
      if (tick.lives.state(static_cast<RobotIndex>(robot)) == RobotState::kReturning) {
        go_back(tick, robot);
        return;
      }
      set(robot, Authority::kGoverned, Ending::kAsGoverned);
      const bool slow =
          tick.severities[robot] >= Severity::kClamp && tick.symptoms[robot].has(Symptom::kLinkDegraded);
      const float share = slow ? kClampedShare : 1.0F;
      wish_of(robot, share * tick.wish.vx()[robot], share * tick.wish.vy()[robot],
              share * tick.wish.vz()[robot]);
      return;
    }
    case CommandKind::kTakeOff:
      set(robot, Authority::kForeign, Ending::kTakeOff);
      return;
    case CommandKind::kLand:
      land(tick, robot);
      return;
    case CommandKind::kStop:
      set(robot, Authority::kForeign, Ending::kStop);
      return;
    case CommandKind::kNone:
      set(robot, Authority::kAtRest, Ending::kNone);
      return;
    case CommandKind::kHold:
      break;
  }
  const RobotState state = tick.lives.state(static_cast<RobotIndex>(robot));
  set(robot, is_armed(state) ? Authority::kBraking : Authority::kAtRest, Ending::kHold);
}

// Down as far as the governor lets it: somebody below it is kept away from. Only then it is left to its
// firmware. One whose place is not known brakes, and is left to it where it stands.
void Orders::land(const Tick& tick, std::size_t robot) noexcept {
  const bool descends = config_.descent > 0.0F && tick.estimate.known[robot] != 0;
  const bool is_down = !descends || tick.estimate.z[robot] <= config_.floor[robot];
  set(robot, is_down ? Authority::kLanding : Authority::kGoverned, Ending::kAsGoverned);
  if (!is_down) {
    const glm::vec3 stay = against_drift(tick, robot);
    // Somebody below may let it neither sink nor, with the same wish, stay where it is: then it stays.
    wish_of(robot, stay.x, stay.y, stays_[robot] != 0 ? -config_.descent : stay.z);
  }
}

// Straight, as far as the governor lets it, ever slower towards the end. Whoever is in its way is kept away
// from, and it waits.
void Orders::go_back(const Tick& tick, std::size_t robot) noexcept {
  const EstimateColumns& e = tick.estimate;
  const Place& there = destination_[robot];
  if (e.known[robot] == 0 || !there.known) {
    set(robot, Authority::kBraking, Ending::kHold);
    return;
  }
  const glm::vec3 way = there.at - glm::vec3(e.x[robot], e.y[robot], e.z[robot]);
  const float distance = glm::length(way);
  const float speed = glm::length(glm::vec3(e.vx[robot], e.vy[robot], e.vz[robot]));
  if (distance < kArrived && speed < kSlow) {
    tick.lives.request(static_cast<RobotIndex>(robot), RobotEvent::kArrived);
    if (lands_there_[robot] != 0) {
      tick.lives.request(static_cast<RobotIndex>(robot), RobotEvent::kLand);
    }
    set(robot, Authority::kBraking, Ending::kHold);
    return;
  }
  set(robot, Authority::kGoverned, Ending::kAsGoverned);
  const glm::vec3 velocity = way * std::min(kHoming, config_.homing / distance);
  wish_of(robot, velocity.x, velocity.y, velocity.z);
}

void Orders::finish(const GovernedColumns& governed) noexcept {
  for (std::size_t robot = 0; robot < ending_.size(); ++robot) {
    const float got = governed.vx[robot] * vx_[robot] + governed.vy[robot] * vy_[robot];
    const float wanted = vx_[robot] * vx_[robot] + vy_[robot] * vy_[robot];
    stays_[robot] = got < kMostOfIt * wanted ? 0 : 1;
    CommandKind& kind = governed.kind[robot];
    const bool rests = governed.vx[robot] == 0.0F && governed.vy[robot] == 0.0F && governed.vz[robot] == 0.0F;
    switch (ending_[robot]) {
      case Ending::kAsGoverned:
        break;
      case Ending::kNone:
        kind = CommandKind::kNone;
        break;
      case Ending::kHold:
        kind =
            rests || ours_[robot] == 0 || authority_[robot] == Authority::kAtRest ? CommandKind::kHold : kind;
        break;
      case Ending::kTakeOff:
        kind = CommandKind::kTakeOff;
        break;
      case Ending::kStop:
        kind = CommandKind::kStop;
        break;
    }
  }
}

}  // namespace mayfly
