#include "controller/guard/guard.hpp"

#include <algorithm>

namespace mayfly {
namespace {

// A gap of more than this many periods is told as one.
constexpr int kGapPeriods = 5;
constexpr float kCreeping = 0.01F;  // m/s

// What only matters of a robot whose motors may turn.
constexpr Symptoms only_in_flight() {
  Symptoms s;
  for (const Symptom one : {Symptom::kSilent, Symptom::kStalePose, Symptom::kFrozenPose, Symptom::kPoseJump,
                            Symptom::kTrackingError, Symptom::kOutOfFence, Symptom::kTooNear,
                            Symptom::kBatteryCritical, Symptom::kLinkDegraded}) {
    s.add(one);
  }
  return s;
}

}  // namespace

void Guard::restart() noexcept {
  wish_.reset();
  orders_.forget();
  monitor_.reset();
  sequence_ = 0;
  last_tick_ = Time::min();
  has_sensed_ = false;
}

HalResult Guard::sense(Time now) noexcept {
  report_.missed_acts += has_sensed_ ? 1U : 0U;
  has_sensed_ = true;
  if (config_.exchange != nullptr) {
    config_.exchange->tick(now, *this);
  }
  const HalResult result = hal_.read(now, estimator_.inbox());
  note_link(result);
  estimator_.update(now);
  sensed_ = now;
  return result;
}

// A link that is down silences those who are on it, or everybody where it is not said which.
void Guard::note_link(const HalResult& result) noexcept {
  if (result.fault == HalFault::kGivenUp) {
    tell(Symptom::kSimulationFailed);
  }
  if (result.fault != HalFault::kLinkDown) {
    return;
  }
  bool found = false;
  const std::span<const RobotInfo> robots = hal_.robots();
  for (RobotIndex i = 0; i < robots.size(); ++i) {
    if (robots[i].link == result.link) {
      tell(i, Symptom::kLinkLost);
      found = true;
    }
  }
  if (!found) {
    tell(Symptom::kLinkLost);
  }
}

HalResult Guard::act(Time now, const CommandColumns& wish) noexcept {
  has_sensed_ = false;
  ++report_.ticks;
  wish_.judge(now, wish);
  gather(now);
  live(now);
  react(now);
  govern(now);
  return write(now);
}

// Everything that is wrong, from all who look. Of a robot that stands with its motors off only what can be
// told of its data is.
void Guard::gather(Time now) noexcept {
  constexpr Symptoms kInFlight = only_in_flight();
  const EstimateColumns e = estimator_.estimate();
  telemetry_.update(now, estimator_.telemetry(), e.stamp, e.known);
  for (std::size_t i = 0; i < robots_; ++i) {
    Symptoms all = e.symptoms[i];
    all.add(telemetry_.symptoms()[i]);
    all.add(governed_[i]);
    all.add(told_of_[i]);
    const bool is_there = present_.empty() || present_[i] != 0;
    if (!is_there || !is_armed(lives_.state(static_cast<RobotIndex>(i)))) {
      all.remove(kInFlight);
    }
    all.add(wish_.symptoms()[i]);
    all.add(monitor_.symptoms()[i]);
    symptoms_[i] = all;
    told_of_[i] = {};
  }
  everybody_ = e.everybody;
  everybody_.add(wish_.everybody());
  everybody_.add(monitor_.everybody());
  everybody_.add(told_);
  told_ = {};
  if (config_.clock != nullptr && last_tick_ != Time::min() &&
      now - last_tick_ > kGapPeriods * config_.period) {
    everybody_.add(Symptom::kTickGap);
  }
  last_tick_ = now;
}

void Guard::live(Time now) noexcept {
  const EstimateColumns e = estimator_.estimate();
  const std::span<const Telemetry> telemetry = estimator_.telemetry();
  for (RobotIndex i = 0; i < robots_; ++i) {
    Observation seen;
    seen.now = now;
    seen.telemetry = telemetry[i];
    seen.sampled = e.known[i] != 0 ? e.stamp[i] : Time::min();
    seen.known = e.known[i] != 0;
    // Who is in the air already is not asked whether he may be.
    seen.fit = telemetry[i].airborne || governed_[i].empty();
    lives_.observe(i, seen);
    follow_severity(i);
  }
}

// From hold-all up a severity is part of a robot's life. Who was made to hold goes on once it is
// acknowledged.
void Guard::follow_severity(RobotIndex robot) noexcept {
  const RobotState state = lives_.state(robot);
  const Severity severity = reactions_.severities()[robot];
  if (severity >= Severity::kLand) {
    held_[robot] = 0;
    if (next_state(state, RobotEvent::kLand)) {
      lives_.request(robot, RobotEvent::kLand);
    }
  } else if (severity == Severity::kHoldAll && state == RobotState::kFlying) {
    held_[robot] = lives_.request(robot, RobotEvent::kHold) ? 1 : 0;
  } else if (severity < Severity::kHoldAll && held_[robot] != 0) {
    held_[robot] = 0;
    lives_.request(robot, RobotEvent::kResume);
  }
}

void Guard::react(Time now) noexcept {
  reactions_.tick(now, symptoms_, everybody_);
  is_incident_ = false;
  for (const Reaction& begun : reactions_.begun()) {
    // An operator's hold is how a flight ends.
    is_incident_ =
        is_incident_ || (begun.severity >= Severity::kHoldAll && begun.symptom != Symptom::kOperatorHold);
    if (events_.size() < kMostEvents) {
      events_.push_back({now, begun.robot, begun.symptom, begun.severity});
    } else {
      ++report_.events_not_kept;
    }
  }
  report_.worst = std::max(report_.worst, reactions_.worst());
}

void Guard::govern(Time now) noexcept {
  const EstimateColumns e = estimator_.estimate();
  orders_.give({wish_, lives_, reactions_.severities(), symptoms_, present_, e});
  const GovernedColumns governed{kind_, vx_, vy_, vz_, governed_};
  governor_.govern(
      now,
      {e.x, e.y, e.z, e.vx, e.vy, e.vz, e.known, orders_.authority(), sensed_ == now ? e.fresh : unmeasured_,
       e.anew, config_.exchange != nullptr ? config_.exchange->kept_clear() : std::span<const KeptClear>()},
      orders_.desired(), governed);
  orders_.finish(governed);
}

HalResult Guard::write(Time now) noexcept {
  deadline_ = now + config_.command_life;
  ++sequence_;
  TickOutcome outcome{now,
                      written(),
                      estimator_.estimate(),
                      lives_.states(),
                      reactions_.severities(),
                      orders_.ours(),
                      governed_,
                      acknowledged_};
  if (config_.tamper) {
    config_.tamper({kind_, vx_, vy_, vz_, governed_}, outcome);
  }
  monitor_.check(outcome);
  for (std::size_t i = 0; i < robots_ && !monitor_.held(); ++i) {
    kind_[i] = monitor_.may_send(i) ? kind_[i] : CommandKind::kHold;
  }
  const HalResult result = hal_.write(now, written());
  note_link(result);
  monitor_.wrote(result);
  was_written_ = result.ok();
  tell_estimator(now);
  end_tick(now, outcome);
  return result;
}

// A robot that creeps may not be seen to move: its place is a float, and so is what a simulated one adds to
// it. It is not taken for frozen.
void Guard::tell_estimator(Time now) noexcept {
  for (std::size_t i = 0; i < robots_; ++i) {
    const float squared = vx_[i] * vx_[i] + vy_[i] * vy_[i] + vz_[i] * vz_[i];
    told_kind_[i] = squared < kCreeping * kCreeping ? CommandKind::kHold : kind_[i];
  }
  estimator_.sent(now, {told_kind_, vx_, vy_, vz_, deadline_, sequence_});
}

void Guard::end_tick(Time now, const TickOutcome& outcome) noexcept {
  black_box_.keep({outcome, wish_, symptoms_, everybody_, monitor_.held()});
  if (is_incident_ || (held_before_ && !monitor_.held())) {
    black_box_.seal();
  }
  held_before_ = monitor_.held();
  acknowledged_ = false;
  if (config_.clock != nullptr) {
    monitor_.took(config_.clock->now() - now);
  }
}

CommandColumns Guard::written() const noexcept {
  return {kind_, vx_, vy_, vz_, deadline_, sequence_};
}

bool Guard::request(RobotIndex robot, RobotEvent event) noexcept {
  const bool accepted = lives_.request(robot, event);
  if (accepted && event == RobotEvent::kReturn) {
    orders_.send_home(robot);
  }
  return accepted;
}

bool Guard::lead(RobotIndex robot, glm::vec3 place) noexcept {
  const bool goes = lives_.request(robot, RobotEvent::kReturn);
  if (goes) {
    orders_.send_to(robot, place);
  }
  return goes;
}

Severity Guard::acknowledge() noexcept {
  acknowledged_ = true;
  return reactions_.acknowledge();
}

GuardReport Guard::report() const noexcept {
  GuardReport report = report_;
  report.incidents = black_box_.incidents();
  report.invariants = monitor_.counters();
  report.reactions = reactions_.counters();
  report.wishes = wish_.counters();
  report.governor = governor_.counters();
  return report;
}

}  // namespace mayfly
