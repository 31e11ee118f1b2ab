#include "controller/link/guard_loop.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace mayfly::link {
namespace {

constexpr float kStandingStill = 0.05F;  // m/s
constexpr float kSinking = 0.1F;         // m/s

template <std::size_t N>
void copy_text(std::string_view from, std::array<char, N>& to) noexcept {
  std::memcpy(to.data(), from.data(), std::min(from.size(), N - 1));
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
    // Also where everybody stands already, because of a wish that ran out before.
    stop_is_told_ = false;
  }
  note(sense_source_, now, parts_.guard.sense(now));
  const CommandColumns wish = next_wish(now);
  heed_operator();
  if (end_.stage() == FlightEnd::Stage::kLanding) {
    land();
  }
  note(act_source_, now, parts_.guard.act(now, wish));
  tell_reactions();
  account(info, now);
  show(now);
  if (end_.update(now, seen()) == FlightEnd::Stage::kDone) {
    finished_.store(true, std::memory_order_relaxed);
  }
}

// The planner's, as long as there is one that does not want the end. One that died leaves a void wish behind,
// and what follows is in the table of reactions.
CommandColumns GuardLoop::next_wish(Time now) noexcept {
  const bool is_ending = end_.stage() != FlightEnd::Stage::kFlying && !report_.planner_died;
  const CommandColumns wish = is_ending ? parts_.end.hold(now) : parts_.end.wish(now);
  wish_until_ = wish.deadline;
  return wish;
}

void GuardLoop::heed_operator() noexcept {
  const int asked =
      std::max(parts_.asked_to_stop.load(std::memory_order_relaxed), static_cast<int>(parts_.end.stop()));
  if (asked > 0) {
    parts_.guard.tell(asked > 1 ? Symptom::kEmergencyStop : Symptom::kOperatorHold);
  }
  if (parts_.end.acknowledged() != acknowledged_) {
    acknowledged_ = parts_.end.acknowledged();
    static_cast<void>(parts_.guard.acknowledge());
  }
}

// Whom the table of lives does not let land (who is down already, or lands) is left as he is.
void GuardLoop::land() noexcept {
  const std::span<const RobotState> states = parts_.guard.states();
  for (RobotIndex robot = 0; robot < states.size(); ++robot) {
    if (next_state(states[robot], RobotEvent::kLand)) {
      static_cast<void>(parts_.guard.request(robot, RobotEvent::kLand));
    }
  }
}

void GuardLoop::note(FaultLog::Source& source, Time now, const HalResult& result) noexcept {
  if (source.begins(result)) {
    Event event{now.count(), result.robot, static_cast<std::uint32_t>(result.fault), 0, 0, {}, {}};
    copy_text(result.link, event.link);
    copy_text(result.cause, event.cause);
    parts_.end.tell(event);
  }
}

void GuardLoop::tell_reactions() noexcept {
  const std::span<const GuardEvent> events = parts_.guard.events();
  for (; reactions_told_ < events.size(); ++reactions_told_) {
    const GuardEvent& begun = events[reactions_told_];
    parts_.end.tell({begun.at.count(),
                     begun.robot,
                     static_cast<std::uint32_t>(HalFault::kNone),
                     static_cast<std::uint32_t>(begun.symptom),
                     static_cast<std::uint32_t>(begun.severity),
                     {},
                     {}});
  }
}

bool GuardLoop::all_told_to_stand() const noexcept {
  const CommandColumns sent = parts_.guard.written();
  for (std::size_t robot = 0; robot < sent.kind.size(); ++robot) {
    const bool moves = sent.kind[robot] == CommandKind::kVelocity &&
                       (sent.vx[robot] != 0.0F || sent.vy[robot] != 0.0F || sent.vz[robot] != 0.0F);
    if (moves || sent.kind[robot] == CommandKind::kTakeOff) {
      return false;
    }
  }
  return true;
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
  if (stop_is_told_ || now <= wish_until_ || !all_told_to_stand()) {
    return;
  }
  stop_is_told_ = true;
  stop_.still = now;
  stop_.late = worst_wake_ + skipped_since_;
  ViewHead& head = *parts_.end.view().head;
  head.wished_ns = stop_.wished.count();
  head.still_ns = stop_.still.count();
  head.late_ns = stop_.late.count();
  if (report_.stops.size() < kMostStops) {
    report_.stops.push_back(stop_);
  }
}

FlightEnd::Seen GuardLoop::seen() const noexcept {
  FlightEnd::Seen seen;
  seen.planner_died = report_.planner_died;
  seen.end_wanted = report_.planner_gone != Time(0) || parts_.end.want() == Want::kEnd;
  seen.all_still = all_told_to_stand();
  const EstimateColumns at = parts_.guard.estimate();
  for (std::size_t robot = 0; robot < at.known.size() && seen.all_still; ++robot) {
    const float speed2 =
        at.vx[robot] * at.vx[robot] + at.vy[robot] * at.vy[robot] + at.vz[robot] * at.vz[robot];
    seen.all_still = at.known[robot] == 0 || speed2 < kStandingStill * kStandingStill;
  }
  // Whose motors are off, or were cut, is not waited for.
  const CommandColumns sent = parts_.guard.written();
  const std::span<const RobotState> states = parts_.guard.states();
  for (std::size_t robot = 0; robot < states.size(); ++robot) {
    const bool flies = is_armed(states[robot]) && states[robot] != RobotState::kArmed;
    seen.airborne = seen.airborne || (flies && sent.kind[robot] != CommandKind::kStop);
    seen.sinking = seen.sinking || (flies && at.known[robot] != 0 && at.vz[robot] < -kSinking);
  }
  return seen;
}

void GuardLoop::show(Time now) noexcept {
  ViewColumns& view = parts_.end.view();
  view.head->time_ns = now.count();
  view.head->tick = report_.ticks;
  view.head->reactions = parts_.guard.reactions();
  *view.report = parts_.guard.report();
  const EstimateColumns at = parts_.guard.estimate();
  const CommandColumns sent = parts_.guard.written();
  const std::array<std::pair<std::span<const float>, std::span<float>>, 9> columns{
      std::pair{at.x, view.x},          std::pair{at.y, view.y},          std::pair{at.z, view.z},
      std::pair{at.vx, view.vx},        std::pair{at.vy, view.vy},        std::pair{at.vz, view.vz},
      std::pair{sent.vx, view.sent_vx}, std::pair{sent.vy, view.sent_vy}, std::pair{sent.vz, view.sent_vz}};
  for (const auto& [from, to] : columns) {
    std::copy(from.begin(), from.end(), to.begin());
  }
  copy_column(at.fresh, view.fresh);
  copy_column(parts_.guard.symptoms(), view.symptoms);
  copy_column(parts_.guard.states(), view.state);
  copy_column(parts_.guard.severities(), view.severity);
  copy_column(sent.kind, view.kind);
  const std::span<const Telemetry> telemetry = parts_.guard.telemetry();
  for (std::size_t robot = 0; robot < at.stamp.size(); ++robot) {
    view.stamp_ns[robot] = at.stamp[robot].count();
    view.heard_ns[robot] = telemetry[robot].heard.count();
    view.battery[robot] = telemetry[robot].battery;
    view.link_quality[robot] = telemetry[robot].link_quality;
    view.airborne[robot] = telemetry[robot].airborne ? 1 : 0;
  }
  parts_.end.show();
}

LinkReport GuardLoop::report() const {
  LinkReport report = report_;
  report.wishes = parts_.end.taken();
  report.refused = parts_.end.refused();
  report.leases_refused = parts_.end.leases_refused();
  return report;
}

}  // namespace mayfly::link
