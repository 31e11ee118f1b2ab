#include "controller/flight/flight.hpp"

#include <algorithm>
#include <utility>

#include "controller/executor/executor.hpp"
#include "controller/flight/estimate.hpp"
#include "controller/flight/expectations.hpp"
#include "controller/flight/fault_log.hpp"
#include "controller/flight/flight_config.hpp"
#include "controller/flight/swarm_models.hpp"
#include "controller/governor/governor.hpp"
#include "controller/metrics/metrics.hpp"

namespace mayfly {
namespace {

// After Ctrl-C the swarm holds until it stands still, but no longer than this.
constexpr double kMostHoldSeconds = 2.0;
constexpr float kStandingStill = 0.05F;  // m/s
// A command is good for this many control periods: long enough for one late tick, short enough to stop soon
// after the last.
constexpr int kCommandPeriods = 5;

struct Columns3 {
  explicit Columns3(std::size_t n) : x(n), y(n), z(n) {}
  VelocityColumns writable() { return {x, y, z}; }
  std::vector<float> x, y, z;
};

// One flight's state: columns taken at the start, and what a tick does with them.
class Flight {
 public:
  Flight(const FlightParts& parts, Governor governor, Metrics metrics)
      : parts_(parts),
        agents_(parts.hal.robots().size()),
        period_(from_seconds(1.0 / static_cast<double>(parts.scenario.control.rate))),
        governor_(std::move(governor)),
        metrics_(std::move(metrics)),
        estimate_(agents_),
        truth_(agents_),
        lead_(lead_times(parts.scenario)),
        ahead_(agents_),
        desired_(agents_),
        command_(agents_),
        kind_(agents_, CommandKind::kHold) {}

  void tick() noexcept {
    const auto work_began = std::chrono::steady_clock::now();
    const Time now = parts_.clock.now();
    if (ticks_ == 0) {
      began_ = now;
    }
    asked_to_stop_ = stop_level();
    note(hal_source_, now, parts_.hal.read(now, estimate_.inbox()));
    note_liar(now, estimate_.update());
    observe_truth();
    decide(now);
    write(now);
    show(now);
    end_if_asked(now);
    ++ticks_;
    flown_ = now - began_ + period_;
    work_ += std::chrono::steady_clock::now() - work_began;
  }

  const std::atomic<bool>& finished() const { return finished_; }
  bool stopped_by_user() const { return stop_level() > 0; }

  Summary summarise(const Executor& executor, double wall_s) const;

 private:
  int stop_level() const { return parts_.stop == nullptr ? 0 : parts_.stop->load(std::memory_order_relaxed); }

  void note(FaultLog::Source& source, Time now, const HalResult& result) noexcept {
    faults_.note(source, now - began_, result);
  }

  void note_liar(Time now, std::optional<RobotIndex> liar) noexcept {
    HalResult result;
    if (liar) {
      result = {HalFault::kNotFinite, *liar, parts_.hal.robots()[*liar].link, "its state is not a number"};
    }
    note(state_source_, now, result);
  }

  // The true state where a simulation knows it, else the estimate: what metrics and observers see.
  void observe_truth() noexcept {
    if (parts_.truth != nullptr) {
      parts_.truth->truth(truth_.inbox());
      static_cast<void>(truth_.update());
    }
    const Estimate& seen = parts_.truth != nullptr ? truth_ : estimate_;
    metrics_.observe({seen.x, seen.y, seen.z, seen.vx, seen.vy, seen.vz});
  }

  static std::vector<float> lead_times(const Scenario& scenario) {
    std::vector<float> lead;
    for (const SwarmSpec& swarm : scenario.swarms) {
      lead.insert(lead.end(), static_cast<std::size_t>(swarm.count), response_time(scenario, swarm));
    }
    return lead;
  }

  // The model steers p + τ·v: of a robot whose velocity lags by τ this point moves exactly as commanded, so
  // the model's paths and distances hold for it, and the robot trails it.
  void look_ahead() noexcept {
    for (std::size_t a = 0; a < agents_; ++a) {
      ahead_.x[a] = estimate_.x[a] + lead_[a] * estimate_.vx[a];
      ahead_.y[a] = estimate_.y[a] + lead_[a] * estimate_.vy[a];
      ahead_.z[a] = estimate_.z[a] + lead_[a] * estimate_.vz[a];
    }
  }

  void decide(Time now) noexcept {
    look_ahead();
    const TickTime tick{ticks_, to_seconds(now - began_), static_cast<float>(to_seconds(period_))};
    moved_ += parts_.engine.compute({ahead_.x, ahead_.y, ahead_.z}, tick, desired_.writable());
    const std::string_view fault = parts_.engine.fault();
    note(engine_source_, now,
         {fault.empty() ? HalFault::kNone : HalFault::kLinkDown, kEveryRobot, parts_.engine.name(), fault});
    governor_.govern(now,
                     {estimate_.x, estimate_.y, estimate_.z, estimate_.vx, estimate_.vy, estimate_.vz,
                      estimate_.stamp, estimate_.valid},
                     {desired_.x, desired_.y, desired_.z}, {kind_, command_.x, command_.y, command_.z});
    if (asked_to_stop_ > 0) {
      std::fill(kind_.begin(), kind_.end(), asked_to_stop_ > 1 ? CommandKind::kStop : CommandKind::kHold);
    }
  }

  void write(Time now) noexcept {
    const CommandColumns commands{
        kind_, command_.x, command_.y, command_.z, now + kCommandPeriods * period_, ++sequence_};
    note(write_source_, now, parts_.hal.write(now, commands));
  }

  void show(Time now) noexcept {
    const Estimate& seen = parts_.truth != nullptr ? truth_ : estimate_;
    const TickView view{ticks_,  now - began_, seen.x,     seen.y,     seen.z, seen.vx,        seen.vy,
                        seen.vz, command_.x,   command_.y, command_.z, kind_,  estimate_.fresh};
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
  void end_if_asked(Time now) noexcept {
    const int level = asked_to_stop_;
    if (level == 0) {
      return;
    }
    if (stop_began_ == Time::min()) {
      stop_began_ = now;
    }
    const Estimate& seen = parts_.truth != nullptr ? truth_ : estimate_;
    bool still = true;
    for (std::size_t a = 0; a < agents_ && still; ++a) {
      still = seen.vx[a] * seen.vx[a] + seen.vy[a] * seen.vy[a] + seen.vz[a] * seen.vz[a] <
              kStandingStill * kStandingStill;
    }
    if (level > 1 || still || now - stop_began_ > from_seconds(kMostHoldSeconds)) {
      finished_.store(true, std::memory_order_relaxed);
    }
  }

  const FlightParts& parts_;
  std::size_t agents_;
  Time period_;
  Governor governor_;
  Metrics metrics_;
  Estimate estimate_;
  Estimate truth_;
  std::vector<float> lead_;  // s, one an agent
  Columns3 ahead_;
  Columns3 desired_;
  Columns3 command_;
  std::vector<CommandKind> kind_;
  FaultLog faults_;
  FaultLog::Source hal_source_, state_source_, write_source_, engine_source_;
  std::uint64_t sequence_ = 0;
  std::uint64_t ticks_ = 0;
  std::uint64_t moved_ = 0;  // agent-ticks in which MDE moved somebody
  Time began_{0};
  Time flown_{0};
  // Read once a tick: a request that comes in its middle must not end the flight before it was written.
  int asked_to_stop_ = 0;
  Time stop_began_ = Time::min();
  std::chrono::steady_clock::duration work_{0};
  std::atomic<bool> finished_{false};
};

std::optional<LatencySummary> told(const std::optional<Percentiles>& p) {
  return p ? std::optional(LatencySummary{p->p50, p->p99, p->p999, p->max}) : std::nullopt;
}

bool has_mde(const Scenario& scenario) {
  return std::any_of(scenario.swarms.begin(), scenario.swarms.end(), [](const SwarmSpec& swarm) {
    return swarm.mde_sweeps > 0 && swarm.limits.separation > 0;
  });
}

Summary Flight::summarise(const Executor& executor, double wall_s) const {
  const Scenario& scenario = parts_.scenario;
  Summary s;
  s.scenario = scenario.name;
  s.engine = parts_.engine.name();
  s.hal = parts_.hal.name();
  s.seed = scenario.seed;
  s.agents = agents_;
  s.ticks = ticks_;
  s.simulated_s = to_seconds(flown_);
  s.wall_s = wall_s;
  s.realtime_factor = wall_s > 0 ? s.simulated_s / wall_s : 0;
  const double agent_ticks = static_cast<double>(agents_) * static_cast<double>(ticks_);
  if (agent_ticks > 0) {
    s.ns_per_agent_tick = std::chrono::duration<double, std::nano>(work_).count() / agent_ticks;
    if (has_mde(scenario)) {
      s.mde_percent = 100.0 * static_cast<double>(moved_) / agent_ticks;
    }
  }
  const MetricsResult measured = metrics_.result();
  s.reached_fraction = measured.reached_fraction;
  s.min_separation_m = measured.min_separation_m;
  s.collisions = measured.collisions;
  s.penetrations = measured.penetrations;
  s.max_speed_mps = measured.max_speed_mps;
  s.max_acceleration_mps2 = measured.max_acceleration_mps2;
  s.governor_interventions = governor_.counters().interventions;
  s.faults = faults_.told(parts_.hal.robots());
  const TaskStats control = executor.stats().front();
  s.control = {control.rate_hz,
               control.ticks,
               control.missed,
               control.missed_by_machine,
               parts_.clock.is_virtual() ? std::nullopt : told(control.jitter),
               told(control.run)};
  s.preprocessing_s = parts_.world.preprocessing;
  s.stopped_by_user = stopped_by_user();
  s.expect = hold_expectations(scenario.expect, s, [&](const std::string& name) -> std::optional<double> {
    if (name.empty()) {
      return measured.reached_fraction;
    }
    const auto swarm = std::find_if(scenario.swarms.begin(), scenario.swarms.end(),
                                    [&](const SwarmSpec& spec) { return spec.name == name; });
    return measured.reached_fraction_of[static_cast<std::size_t>(swarm - scenario.swarms.begin())];
  });
  return s;
}

}  // namespace

Result<Summary> fly(const FlightParts& parts) {
  auto governor = Governor::make(governor_config(parts.scenario, parts.world));
  if (!governor) {
    return fail(std::move(governor.error()));
  }
  if (auto configured = parts.hal.configure(); !configured) {
    return fail(std::move(configured.error()));
  }
  if (parts.hal.robots().size() != governor->agents()) {
    return fail(Cause::kDevice, "the HAL has " + std::to_string(parts.hal.robots().size()) +
                                    " robots, the scenario " + std::to_string(governor->agents()) +
                                    " agents");
  }
  Flight flight(parts, std::move(*governor), Metrics(metrics_config(parts.scenario, parts.world)));
  Executor executor(parts.clock);
  auto added = executor.add_task("control", static_cast<double>(parts.scenario.control.rate),
                                 [&flight](const TickInfo&) noexcept { flight.tick(); });
  if (!added) {
    return fail(std::move(added.error()));
  }
  const auto start = std::chrono::steady_clock::now();
  if (auto activated = parts.hal.activate(parts.clock.now()); !activated) {
    return fail(std::move(activated.error()));
  }
  executor.run(from_seconds(parts.scenario.duration), flight.finished());
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  auto deactivated = parts.hal.deactivate(parts.clock.now());
  if (!deactivated) {
    return fail(std::move(deactivated.error()));
  }
  return flight.summarise(executor, wall_s);
}

}  // namespace mayfly
