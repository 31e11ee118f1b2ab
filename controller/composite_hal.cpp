#include "controller/composite_hal.hpp"

#include <unordered_set>
#include <utility>

namespace mayfly {

namespace {

StateColumns part(const StateColumns& s, std::size_t from, std::size_t n) noexcept {
  return {s.x.subspan(from, n),
          s.y.subspan(from, n),
          s.z.subspan(from, n),
          s.vx.subspan(from, n),
          s.vy.subspan(from, n),
          s.vz.subspan(from, n),
          s.stamp.subspan(from, n),
          s.valid.subspan(from, n),
          s.telemetry.empty() ? s.telemetry : s.telemetry.subspan(from, n)};
}

CommandColumns part(const CommandColumns& c, std::size_t from, std::size_t n) noexcept {
  return {c.kind.subspan(from, n),
          c.vx.subspan(from, n),
          c.vy.subspan(from, n),
          c.vz.subspan(from, n),
          c.deadline,
          c.sequence};
}

// A link is more than a robot, a HAL that has given up more than a link, and a robot that was told something
// else than it was to be told comes before all others.
int gravity(HalFault fault) noexcept {
  switch (fault) {
    case HalFault::kNone:
      return 0;
    case HalFault::kLinkDown:
      return 2;
    case HalFault::kGivenUp:
      return 3;
    case HalFault::kMisencoded:
      return 4;
    default:
      return 1;
  }
}

// Keeps the first of the gravest faults, its robot counted in the whole.
void merge(HalResult& whole, HalResult child, std::size_t from) noexcept {
  if (gravity(child.fault) <= gravity(whole.fault)) {
    return;
  }
  if (child.robot != kEveryRobot) {
    child.robot += static_cast<RobotIndex>(from);
  }
  whole = child;
}

}  // namespace

CompositeHal::CompositeHal(std::string name, std::vector<std::unique_ptr<Hal>> children)
    : name_(std::move(name)), children_(std::move(children)) {}

Result<void> CompositeHal::do_configure() {
  std::unordered_set<std::string> names;
  std::vector<RobotInfo> infos;
  for (const auto& child : children_) {
    // A second try finds some of them configured already.
    if (child->state() == HalState::kCreated) {
      if (auto done = child->configure(); !done) {
        return done;
      }
    }
    for (const RobotInfo& info : child->robots()) {
      if (!names.insert(info.name).second) {
        return fail(Cause::kCaller, name_ + ": two robots are called '" + info.name + "'");
      }
      infos.push_back(info);
    }
  }
  infos_ = std::move(infos);
  return {};
}

Result<void> CompositeHal::do_activate(Time now) {
  for (const auto& child : children_) {
    if (auto done = child->activate(now); !done) {
      static_cast<void>(do_deactivate(now));  // the first failure is the one to tell
      return done;
    }
  }
  return {};
}

HalResult CompositeHal::do_read(Time now, const StateColumns& states) noexcept {
  HalResult whole;
  std::size_t from = 0;
  for (const auto& child : children_) {
    const std::size_t n = child->robots().size();
    merge(whole, child->read(now, part(states, from, n)), from);
    from += n;
  }
  return whole;
}

HalResult CompositeHal::do_write(Time now, const CommandColumns& commands) noexcept {
  HalResult whole;
  std::size_t from = 0;
  for (const auto& child : children_) {
    const std::size_t n = child->robots().size();
    merge(whole, child->write(now, part(commands, from, n)), from);
    from += n;
  }
  return whole;
}

// Every child, whatever became of those before: a robot that cannot be stopped is no reason to let the others
// fly.
Result<void> CompositeHal::do_deactivate(Time now) {
  Result<void> whole;
  for (const auto& child : children_) {
    auto done = child->deactivate(now);
    if (whole && !done) {
      whole = std::move(done);
    }
  }
  return whole;
}

}  // namespace mayfly
