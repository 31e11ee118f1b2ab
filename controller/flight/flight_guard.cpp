#include "controller/flight/flight_guard.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "controller/flight/flight_config.hpp"
#include "controller/flight/swarm_models.hpp"
#include "core/armed_tick.hpp"

namespace mayfly {
namespace {

// A plan is good for this many control periods: long enough for one late tick, short enough to stop soon
// after the last.
constexpr int kPlanPeriods = 5;

const HalSpec* hal_of(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = std::find_if(scenario.hals.begin(), scenario.hals.end(),
                                [&](const HalSpec& spec) { return spec.name == swarm.robots; });
  return hal == scenario.hals.end() ? nullptr : &*hal;
}

// m: what a coordinate's float can be off by, and a little more. A robot that stays within it has not frozen.
float resolution(const Box& bounds) {
  float farthest = 0.0F;
  for (int axis = 0; axis < 3; ++axis) {
    farthest = std::max({farthest, std::fabs(bounds.min[axis]), std::fabs(bounds.max[axis])});
  }
  return 8.0F * (std::nextafter(farthest, std::numeric_limits<float>::infinity()) - farthest);
}

// One filter for all: as noisy and as late as the worst of the HALs.
EstimatorConfig estimator_config(const Scenario& scenario) {
  EstimatorConfig config;
  config.period = from_seconds(1.0 / static_cast<double>(scenario.control.rate));
  config.most_age = most_state_age(scenario);
  config.most_ahead = config.most_age;
  config.frozen_samples = std::numeric_limits<int>::max();
  config.sources.front().resolution = resolution(scenario.world.bounds);
  Time delay{0};
  for (const SwarmSpec& swarm : scenario.swarms) {
    EstimatorLimits limits;
    limits.acceleration = swarm.limits.acceleration;
    limits.speed = std::numeric_limits<float>::infinity();
    if (swarm.governor) {
      limits.speed = swarm.limits.speed;
      config.frozen_samples = EstimatorConfig{}.frozen_samples;
    }
    if (const HalSpec* hal = hal_of(scenario, swarm)) {
      limits.response_time = hal->sim.plant == PlantKind::kVelocityLag ? hal->sim.time_constant : 0.0F;
      config.sources.front().pose_noise = std::max(config.sources.front().pose_noise, hal->sim.pose_noise);
      config.pose_period =
          std::max(config.pose_period, from_seconds(1.0 / static_cast<double>(hal->sim.rate)));
      delay = std::max(delay, from_seconds(static_cast<double>(hal->sim.delay)));
    }
    config.robots.insert(config.robots.end(), static_cast<std::size_t>(swarm.count), limits);
  }
  config.pose_period = std::max(config.pose_period, config.period);
  config.most_age += delay;
  return config;
}

}  // namespace

GuardConfig guard_config(const Scenario& scenario, const World& world, const Motion& motion,
                         const Clock& clock) {
  GuardConfig config;
  config.governor = governor_config(scenario, world, motion);
  config.period = config.governor.period;
  config.estimator = estimator_config(scenario);
  config.life_cycle.robots = config.estimator.robots.size();
  config.most_plan_age = kPlanPeriods * config.period;
  config.command_life = config.governor.command_life;
  config.hooks.allocations = ArmedTick::offences;
  // On a virtual clock a tick takes no time, but for what a scenario's faults take.
  if (clock.is_virtual() || scenario.control.realtime == RealtimePolicy::kEnforce) {
    config.clock = &clock;
    config.tick_budget = config.period;
  }
  return config;
}

SafetySummary told_of(const GuardPort& guard) {
  const GuardReport report = guard.report();
  SafetySummary told;
  told.severity_max = key_of(report.worst);
  for (std::size_t i = 0; i < kInvariants; ++i) {
    told.invariants.emplace_back(key_of(static_cast<Invariant>(i)), report.invariants.breaches[i]);
  }
  for (std::size_t s = 1; s < kSeverities; ++s) {
    told.reactions.emplace_back(key_of(static_cast<Severity>(s)), report.reactions.begun[s]);
  }
  told.wishes_refused = report.wishes.refused;
  told.stalled_ticks = report.wishes.stalled;
  told.incidents = report.incidents;
  return told;
}

std::vector<FaultEvent> with_reactions(std::vector<FaultEvent> faults, const GuardPort& guard, Time began) {
  const std::span<const RobotInfo> robots = guard.robots();
  for (const GuardEvent& event : guard.events()) {
    const bool is_one = event.robot < robots.size();
    faults.push_back({to_seconds(event.at - began), is_one ? robots[event.robot].name : "",
                      is_one ? robots[event.robot].link : "guard", std::string(info_of(event.symptom).cause),
                      std::string(key_of(event.severity))});
  }
  if (const std::uint64_t more = guard.report().events_not_kept; more > 0) {
    faults.push_back({0.0, "", "guard", std::to_string(more) + " more reactions were not kept", ""});
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const FaultEvent& a, const FaultEvent& b) { return a.time_s < b.time_s; });
  return faults;
}

}  // namespace mayfly
