#include "controller/flight/flight_loop.hpp"

#include <algorithm>
#include <utility>

#include "controller/flight/flight_config.hpp"
#include "controller/flight/swarm_models.hpp"

namespace mayfly {
namespace {

// After Ctrl-C the swarm holds until it stands still, but no longer than this.
constexpr double kMostHoldSeconds = 2.0;
constexpr float kStandingStill = 0.05F;  // m/s
// A command is good for this many control periods: long enough for one late tick, short enough to stop soon
// after the last.
constexpr int kCommandPeriods = 5;

std::vector<std::uint8_t> who_avoids(const Scenario& scenario) {
  std::vector<std::uint8_t> avoids;
  for (const SwarmSpec& swarm : scenario.swarms) {
    avoids.insert(avoids.end(), static_cast<std::size_t>(swarm.count), swarm.avoidance.on ? 1 : 0);
  }
  const bool any = std::find(avoids.begin(), avoids.end(), 1) != avoids.end();
  return any ? avoids : std::vector<std::uint8_t>();
}

std::vector<float> lead_times(const Scenario& scenario) {
  std::vector<float> lead;
  for (const SwarmSpec& swarm : scenario.swarms) {
    lead.insert(lead.end(), static_cast<std::size_t>(swarm.count), response_time(scenario, swarm));
  }
  return lead;
}

}  // namespace

FlightLoop::FlightLoop(const FlightParts& parts, Motion& motion, FieldKeeper* keeper, Governor governor,
                       Metrics metrics)
    : parts_(parts),
      motion_(motion),
      keeper_(keeper),
      agents_(parts.hal.robots().size()),
      period_(from_seconds(1.0 / static_cast<double>(parts.scenario.control.rate))),
      governor_(std::move(governor)),
      metrics_(std::move(metrics)),
      estimate_(agents_),
      truth_(agents_),
      roster_(parts.scenario),
      stimuli_(parts.scenario),
      lead_(lead_times(parts.scenario)),
      avoids_(who_avoids(parts.scenario)),
      there_(roster_.changes() ? agents_ : 0),
      ahead_(agents_),
      desired_(agents_),
      command_(agents_),
      known_(agents_),
      authority_(agents_, Authority::kGoverned),
      kind_(agents_, CommandKind::kHold),
      goal_sources_(parts.scenario.swarms.size()) {}

void FlightLoop::tick() noexcept {
  const auto work_began = std::chrono::steady_clock::now();
  const Time now = parts_.clock.now();
  if (ticks_ == 0) {
    began_ = now;
  }
  motion_.set_time(seconds_flown(now));
  roster_.set_time(seconds_flown(now));
  stimuli_.move(seconds_flown(now), parts_.engine);
  asked_to_stop_ = stop_level();
  note(hal_source_, now, parts_.hal.read(now, estimate_.inbox()));
  note_liar(now, estimate_.update());
  observe_truth();
  renew_fields(now);
  decide(now);
  write(now);
  show(now);
  end_if_asked(now);
  ++ticks_;
  flown_ = now - began_ + period_;
  work_ += std::chrono::steady_clock::now() - work_began;
}

void FlightLoop::note(FaultLog::Source& source, Time now, const HalResult& result) noexcept {
  faults_.note(source, now - began_, result);
}

void FlightLoop::note_liar(Time now, std::optional<RobotIndex> liar) noexcept {
  HalResult result;
  if (liar) {
    result = {HalFault::kNotFinite, *liar, parts_.hal.robots()[*liar].link, "its state is not a number"};
  }
  note(state_source_, now, result);
}

void FlightLoop::observe_truth() noexcept {
  if (parts_.truth != nullptr) {
    parts_.truth->truth(truth_.inbox());
    static_cast<void>(truth_.update());
  }
  const Estimate& at = seen();
  metrics_.observe({at.x, at.y, at.z, at.vx, at.vy, at.vz, roster_.present()});
}

void FlightLoop::renew_fields(Time now) noexcept {
  if (keeper_ == nullptr) {
    return;
  }
  PositionColumns at{estimate_.x, estimate_.y, estimate_.z};
  if (roster_.changes()) {
    std::copy(at.x.begin(), at.x.end(), there_.x.begin());
    std::copy(at.y.begin(), at.y.end(), there_.y.begin());
    std::copy(at.z.begin(), at.z.end(), there_.z.begin());
    leave_out_absent(there_);
    at = {there_.x, there_.y, there_.z};
  }
  keeper_->tick(seconds_flown(now), at, motion_, parts_.engine);
  note(solver_source_, now, keeper_->solver_state());
  for (std::size_t s = 0; s < goal_sources_.size(); ++s) {
    const std::uint64_t before = faults_.count();
    note(goal_sources_[s], now, keeper_->state_of(s));
    if (faults_.count() > before) {
      keeper_->count_unreachable();
    }
  }
}

// The model steers p + τ·v: of a robot whose velocity lags by τ this point moves exactly as commanded, so
// the model's paths and distances hold for it, and the robot trails it.
void FlightLoop::look_ahead() noexcept {
  for (std::size_t a = 0; a < agents_; ++a) {
    ahead_.x[a] = estimate_.x[a] + lead_[a] * estimate_.vx[a];
    ahead_.y[a] = estimate_.y[a] + lead_[a] * estimate_.vy[a];
    ahead_.z[a] = estimate_.z[a] + lead_[a] * estimate_.vz[a];
  }
}

// Who is not there has no place, and nobody minds it.
void FlightLoop::leave_out_absent(Columns3& places) const noexcept {
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t a = 0; a < agents_ && roster_.changes(); ++a) {
    if (!roster_.is_there(a)) {
      places.x[a] = places.y[a] = places.z[a] = kNowhere;
    }
  }
}

void FlightLoop::count_infeasible(Time now, std::size_t infeasible) noexcept {
  std::size_t avoiding = 0;
  for (std::size_t a = 0; a < avoids_.size(); ++a) {
    avoiding += avoids_[a] != 0 && std::isfinite(ahead_.x[a]) ? 1U : 0U;
  }
  infeasible_ += infeasible;
  avoiding_ += avoiding;
  if (avoiding > 0 && infeasible >= avoiding && !all_infeasible_s_) {
    all_infeasible_s_ = seconds_flown(now);
    note(avoidance_source_, now, {HalFault::kLinkDown, kEveryRobot, "avoidance", "every agent infeasible"});
  }
}

// A stamp from the future would never grow old.
void FlightLoop::judge_ages(Time now) noexcept {
  const Time most = most_state_age(parts_.scenario);
  for (std::size_t a = 0; a < agents_; ++a) {
    const Time age = now - estimate_.stamp[a];
    known_[a] = estimate_.valid[a] != 0 && age <= most && age >= -most ? 1 : 0;
    authority_[a] = roster_.is_there(a) ? Authority::kGoverned : Authority::kAbsent;
  }
}

void FlightLoop::decide(Time now) noexcept {
  look_ahead();
  const TickTime tick{ticks_, seconds_flown(now), static_cast<float>(to_seconds(period_))};
  leave_out_absent(ahead_);
  const TickCounts counts = parts_.engine.compute(
      {ahead_.x, ahead_.y, ahead_.z, command_.x, command_.y, command_.z}, tick, desired_.writable());
  moved_ += counts.moved;
  count_infeasible(now, counts.infeasible);
  const std::string_view fault = parts_.engine.fault();
  note(engine_source_, now,
       {fault.empty() ? HalFault::kNone : HalFault::kLinkDown, kEveryRobot, parts_.engine.name(), fault});
  judge_ages(now);
  governor_.govern(
      now,
      {estimate_.x, estimate_.y, estimate_.z, estimate_.vx, estimate_.vy, estimate_.vz, known_, authority_},
      {desired_.x, desired_.y, desired_.z}, {kind_, command_.x, command_.y, command_.z});
  for (std::size_t a = 0; a < agents_ && roster_.changes(); ++a) {
    kind_[a] = roster_.is_there(a) ? kind_[a] : CommandKind::kHold;
  }
  if (asked_to_stop_ > 0) {
    std::fill(kind_.begin(), kind_.end(), asked_to_stop_ > 1 ? CommandKind::kStop : CommandKind::kHold);
  }
}

void FlightLoop::write(Time now) noexcept {
  const CommandColumns commands{
      kind_, command_.x, command_.y, command_.z, now + kCommandPeriods * period_, ++sequence_};
  note(write_source_, now, parts_.hal.write(now, commands));
}

void FlightLoop::show(Time now) noexcept {
  const Estimate& at = seen();
  const TickView view{
      ticks_, now - began_, at.x,       at.y,       at.z,  at.vx,           at.vy,
      at.vz,  command_.x,   command_.y, command_.z, kind_, estimate_.fresh, roster_.present()};
  for (Observer* observer : parts_.observers) {
    observer->on_tick(view);
  }
  if (parts_.gauge != nullptr) {
    parts_.gauge->flown_ns.store((now - began_ + period_).count(), std::memory_order_relaxed);
    parts_.gauge->faults.store(faults_.count(), std::memory_order_relaxed);
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
