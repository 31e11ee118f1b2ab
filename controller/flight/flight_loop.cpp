#include "controller/flight/flight_loop.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "controller/flight/flight_config.hpp"

namespace mayfly {
namespace {

// After Ctrl-C the swarm holds until it stands still, but no longer than this.
constexpr double kMostHoldSeconds = 2.0;
constexpr float kStandingStill = 0.05F;  // m/s
// A wish is good for this many control periods: long enough for one late tick, short enough to stop soon
// after the last.
constexpr int kWishPeriods = 5;

}  // namespace

FlightLoop::FlightLoop(const FlightParts& parts, Motion& motion, FieldPlanner& planner,
                       CurlNoisePlanner* beside, GuardPort& guard, Metrics metrics)
    : parts_(parts),
      motion_(motion),
      planner_(planner),
      beside_(beside),
      agents_(parts.hal.robots().size()),
      period_(from_seconds(1.0 / static_cast<double>(parts.scenario.control.rate))),
      guard_(guard),
      metrics_(std::move(metrics)),
      estimate_(agents_),
      truth_(agents_),
      roster_(parts.scenario),
      plan_(beside == nullptr ? agents_ : 0, parts.scenario.swarms.size()),
      desired_(agents_),
      kind_(agents_, CommandKind::kHold),
      goal_sources_(parts.scenario.swarms.size()) {}

void FlightLoop::sense() noexcept {
  const auto work_began = std::chrono::steady_clock::now();
  now_ = parts_.clock.now();
  if (ticks_ == 0) {
    began_ = now_;
  }
  motion_.set_time(seconds_flown(now_));
  roster_.set_time(seconds_flown(now_));
  asked_to_stop_ = stop_level();
  note(hal_source_, now_, guard_.read(now_, estimate_.inbox()));
  static_cast<void>(estimate_.update());
  observe_truth();
  if (beside_ != nullptr) {
    beside_->offer(now_, view());
  }
  work_ += std::chrono::steady_clock::now() - work_began;
}

void FlightLoop::act() noexcept {
  const auto work_began = std::chrono::steady_clock::now();
  decide(now_);
  write(now_);
  show(now_);
  end_if_asked(now_);
  ++ticks_;
  flown_ = now_ - began_ + period_;
  work_ += std::chrono::steady_clock::now() - work_began;
}

void FlightLoop::note(FaultLog::Source& source, Time now, const HalResult& result) noexcept {
  faults_.note(source, now - began_, result);
}

void FlightLoop::observe_truth() noexcept {
  if (parts_.truth != nullptr) {
    parts_.truth->truth(truth_.inbox());
    static_cast<void>(truth_.update());
  }
  const Estimate& at = seen();
  metrics_.observe({at.x, at.y, at.z, at.vx, at.vy, at.vz, roster_.present()});
}

SwarmView FlightLoop::view() const noexcept {
  const CommandColumns sent = guard_.written();
  return {seconds_flown(now_), estimate_.x,  estimate_.y, estimate_.z, estimate_.vx,
          estimate_.vy,        estimate_.vz, sent.vx,     sent.vy,     sent.vz};
}

const Plan* FlightLoop::newest_plan(Time now) noexcept {
  if (beside_ == nullptr) {
    planner_.plan(ticks_, view(), plan_);
    return &plan_;
  }
  const Plan* plan = beside_->newest(now);
  note(planner_source_, now, beside_->fault(now - began_, plan));
  return plan;
}

void FlightLoop::note_found(Time now, const Plan& plan) noexcept {
  note(solver_source_, now, plan.solver);
  for (std::size_t s = 0; s < goal_sources_.size(); ++s) {
    const std::uint64_t before = faults_.count();
    note(goal_sources_[s], now, plan.goals[s]);
    if (faults_.count() > before) {
      planner_.keeper()->count_unreachable();
    }
  }
  if (plan.all_infeasible_s && !all_infeasible_s_) {
    all_infeasible_s_ = plan.all_infeasible_s;
    note(avoidance_source_, now, {HalFault::kLinkDown, kEveryRobot, "avoidance", "every agent infeasible"});
  }
  note(engine_source_, now, plan.engine);
}

// Before the first plan everybody holds. Later on a plan that is missing is none that may be flown: a wish
// that has run out tells the guard so.
void FlightLoop::wish(Time now, const Plan* plan) noexcept {
  if (plan != nullptr) {
    if (!has_planned_) {
      has_planned_ = true;
      std::fill(kind_.begin(), kind_.end(), CommandKind::kVelocity);
    }
    std::copy(plan->velocity.x.begin(), plan->velocity.x.end(), desired_.x.begin());
    std::copy(plan->velocity.y.begin(), plan->velocity.y.end(), desired_.y.begin());
    std::copy(plan->velocity.z.begin(), plan->velocity.z.end(), desired_.z.begin());
  }
  wish_until_ = plan != nullptr || !has_planned_ ? now + kWishPeriods * period_ : now - Time(1);
}

void FlightLoop::decide(Time now) noexcept {
  const Plan* plan = newest_plan(now);
  if (plan != nullptr) {
    note_found(now, *plan);
  }
  wish(now, plan);
}

void FlightLoop::write(Time now) noexcept {
  guard_.set_present(roster_.present());
  guard_.ask_to_stop(asked_to_stop_);
  note(write_source_, now,
       guard_.write(now, {kind_, desired_.x, desired_.y, desired_.z, wish_until_, ++sequence_}));
}

void FlightLoop::show(Time now) noexcept {
  const Estimate& at = seen();
  const CommandColumns sent = guard_.written();
  const TickView view{ticks_, now - began_, at.x,    at.y,    at.z,      at.vx,           at.vy,
                      at.vz,  sent.vx,      sent.vy, sent.vz, sent.kind, estimate_.fresh, roster_.present()};
  for (Observer* observer : parts_.observers) {
    observer->on_tick(view);
  }
  if (parts_.gauge != nullptr) {
    parts_.gauge->flown_ns.store((now - began_ + period_).count(), std::memory_order_relaxed);
    parts_.gauge->faults.store(faults_.count() + guard_.reactions(), std::memory_order_relaxed);
  }
}

// Asked to stop, the swarm holds until it stands still; asked twice, it has just been told to stop, and
// that is all.
void FlightLoop::end_if_asked(Time now) noexcept {
  const int level = asked_to_stop_;
  if (level == 0) {
    return;
  }
  if (stop_began_ == Time::min()) {
    stop_began_ = now;
  }
  const Estimate& at = seen();
  bool still = true;
  for (std::size_t a = 0; a < agents_ && still; ++a) {
    still = at.vx[a] * at.vx[a] + at.vy[a] * at.vy[a] + at.vz[a] * at.vz[a] < kStandingStill * kStandingStill;
  }
  if (level > 1 || still || now - stop_began_ > from_seconds(kMostHoldSeconds)) {
    finished_.store(true, std::memory_order_relaxed);
  }
}

}  // namespace mayfly
