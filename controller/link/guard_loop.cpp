#include "controller/link/guard_loop.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mayfly::link {
namespace {

constexpr float kStandingStill = 0.05F;  // m/s

template <std::size_t N>
void copy_text(std::string_view from, std::array<char, N>& to) noexcept {
  const std::size_t length = std::min(from.size(), N - 1);
  std::memcpy(to.data(), from.data(), length);
}

template <class From, class To>
void copy_column(std::span<const From> from, std::span<To> to) noexcept {
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) {
    to[i] = static_cast<To>(from[i]);
  }
}

}  // namespace

GuardLoop::GuardLoop(const GuardParts& parts) : parts_(parts) {
  report_.stops.reserve(kMostStops);
}

void GuardLoop::tick(const TickInfo& info) noexcept {
  const Time now = parts_.clock.now();
  if (report_.planner_gone == Time(0) && parts_.planner_gone.load(std::memory_order_relaxed)) {
    report_.planner_gone = now;
    report_.planner_died = parts_.end.want() != Want::kEnd;
    parts_.end.planner_gone();
  }
  const HalResult sensed = parts_.guard.sense(now);
  note(sense_source_, now, sensed);
  const HalResult acted = parts_.guard.act(now, next_wish(now));
  note(act_source_, now, acted);
  account(info, now);
  show(now, acted.ok() ? sensed : acted);
  if (end_.update(now, seen()) == FlightEnd::Stage::kDone) {
    finished_.store(true, std::memory_order_relaxed);
  }
}

// The planner's, as long as there is one and nobody asks to stop. A planner that died leaves a void one
// behind: what follows is in the table of reactions, until everybody rests.
CommandColumns GuardLoop::next_wish(Time now) noexcept {
  CommandColumns wish = parts_.end.wish(now);
  heed_operator();
  const int asked =
      std::max(parts_.asked_to_stop.load(std::memory_order_relaxed), static_cast<int>(parts_.end.stop()));
  if (asked > 1) {
    wish = parts_.end.own_wish(CommandKind::kStop, now);
  } else if (end_.stage() == FlightEnd::Stage::kLanding) {
    wish = parts_.end.own_wish(CommandKind::kLand, now);
  } else if (end_.stage() == FlightEnd::Stage::kBraking && !report_.planner_died) {
    wish = parts_.end.own_wish(CommandKind::kHold, now);
  }
  wish_until_ = wish.deadline;
  return wish;
}

void GuardLoop::heed_operator() noexcept {
  if (parts_.end.acknowledged() != acknowledged_) {
    acknowledged_ = parts_.end.acknowledged();
    static_cast<void>(parts_.guard.acknowledge());
  }
}

void GuardLoop::note(FaultLog::Source& source, Time now, const HalResult& result) noexcept {
  if (source.begins(result.fault, result.robot)) {
    Event event{now.count(), result.robot, static_cast<std::uint32_t>(result.fault), {}, {}};
    copy_text(result.link, event.link);
    copy_text(result.cause, event.cause);
    parts_.end.tell(event);
  }
}

// From the last wish to the write in which the last robot was told to stand still, and how late the machine
// was in between: a skipped release is a whole period, the latest wake-up comes on top.
void GuardLoop::account(const TickInfo& info, Time now) noexcept {
  ++report_.ticks;
  report_.skipped += info.skipped;
  if (parts_.end.taken() != taken_before_) {
    taken_before_ = parts_.end.taken();
    stop_ = {parts_.end.issued(), Time(0), Time(0)};
    worst_wake_ = skipped_since_ = Time(0);
    stop_is_told_ = false;
  }
  worst_wake_ = std::max(worst_wake_, now - info.scheduled);
  skipped_since_ += static_cast<Time::rep>(info.skipped) * info.period;
  if (!stop_is_told_ && now > wish_until_ && parts_.robots.all_still()) {
    stop_is_told_ = true;
    stop_.still = std::max(parts_.robots.still_since(), stop_.wished);
    stop_.late = worst_wake_ + skipped_since_;
    if (report_.stops.size() < kMostStops) {
      report_.stops.push_back(stop_);
    }
  }
}

FlightEnd::Seen GuardLoop::seen() const noexcept {
  FlightEnd::Seen seen;
  seen.end_wanted = report_.planner_gone != Time(0) || parts_.end.want() == Want::kEnd;
  seen.all_still = parts_.robots.all_still();
  const EstimateColumns at = parts_.guard.estimate();
  for (std::size_t robot = 0; robot < at.known.size() && seen.all_still; ++robot) {
    const float speed2 =
        at.vx[robot] * at.vx[robot] + at.vy[robot] * at.vy[robot] + at.vz[robot] * at.vz[robot];
    seen.all_still = at.known[robot] == 0 || speed2 < kStandingStill * kStandingStill;
  }
  const auto states = parts_.guard.states();
  seen.airborne = std::any_of(states.begin(), states.end(), [](RobotState state) {
    return state == RobotState::kReturning || state == RobotState::kLanding;
  });
  return seen;
}

void GuardLoop::show(Time now, const HalResult& result) noexcept {
  ViewColumns& view = parts_.end.view();
  const HalCounters& counters = parts_.robots.counters();
  view.head->time_ns = now.count();
  view.head->tick = report_.ticks;
  view.head->reads = counters.reads.load(std::memory_order_relaxed);
  view.head->writes = counters.writes.load(std::memory_order_relaxed);
  view.head->refused_calls = counters.refused_calls.load(std::memory_order_relaxed);
  view.head->refused_commands = counters.refused_commands.load(std::memory_order_relaxed);
  view.head->hal_fault = static_cast<std::uint32_t>(result.fault);
  const EstimateColumns at = parts_.guard.estimate();
  copy_column(at.x, view.x);
  copy_column(at.y, view.y);
  copy_column(at.z, view.z);
  copy_column(at.vx, view.vx);
  copy_column(at.vy, view.vy);
  copy_column(at.vz, view.vz);
  copy_column(at.known, view.known);
  for (std::size_t robot = 0; robot < at.stamp.size(); ++robot) {
    view.stamp_ns[robot] = at.stamp[robot].count();
  }
  copy_column(parts_.guard.states(), view.state);
  copy_column(parts_.guard.severities(), view.severity);
  copy_column(parts_.robots.kind(), view.kind);
  copy_column(parts_.robots.vx(), view.sent_vx);
  copy_column(parts_.robots.vy(), view.sent_vy);
  copy_column(parts_.robots.vz(), view.sent_vz);
  parts_.end.show();
}

LinkReport GuardLoop::report() const {
  LinkReport report = report_;
  report.wishes = parts_.end.taken();
  report.refused = parts_.end.refused();
  return report;
}

}  // namespace mayfly::link
