#include "bench/faults/fault_flight.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "bench/faults/command_watch.hpp"
#include "bench/faults/guard_witness.hpp"
#include "bench/faults/hostile_engine.hpp"
#include "controller/clock/virtual_clock.hpp"
#include "controller/flight/flight.hpp"
#include "controller/flight/flight_guard.hpp"
#include "controller/flight/motion.hpp"
#include "controller/flight/noticed.hpp"
#include "controller/safety/reaction_table.hpp"
#include "controller/scenario/load.hpp"
#include "simulate/robots.hpp"
#include "simulate/sabotage.hpp"

namespace mayfly::bench {
namespace {

constexpr auto kScenario = R"(mayfly: 1
name: faults
duration: 4
world:
  bounds: {min: [0, 0, 0], max: [6, 6, 3]}
  cell: 0.5
  goals:
    middle: {sphere: {center: [3, 3, 1.5], radius: 0.5}}
swarms:
  - name: flies
    count: 8
    start: {box: {min: [0.5, 0.5, 0.5], max: [5.5, 5.5, 2.5]}}
    goal: middle
    limits: {speed: 2, acceleration: 4, separation: 0.3, tube: 0.05}
    radius: 0.1
control: {rate: 50}
hal:
  sim: {kind: sim, plant: velocity_lag, time_constant: 0.1, rate: 200, pose_noise: 0.003, delay: 0.02, links: 2}
)";

constexpr std::uint64_t kNever = 1'000'000;  // ticks
constexpr double kLongFrozen = 0.14;         // s, told to move: by then it has to be seen
constexpr float kStartApart = 0.8F;          // m
constexpr float kTooFast = 1.5F;             // the planner's speed, by the limit

// Uniform numbers that follow from the seed (SplitMix64, Steele et al. 2014).
class Chances {
 public:
  explicit Chances(std::uint64_t seed) : state_(seed) {}
  double between(double low, double high) {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return low + (high - low) * static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(count))));
  }

 private:
  std::uint64_t state_;
};

std::vector<glm::vec3> start_anywhere(const Box& box, std::size_t count, Chances& chances) {
  std::vector<glm::vec3> places;
  while (places.size() < count) {
    glm::vec3 place(0.0F);
    for (int axis = 0; axis < 3; ++axis) {
      place[axis] = static_cast<float>(
          chances.between(static_cast<double>(box.min[axis]), static_cast<double>(box.max[axis])));
    }
    const bool free = std::all_of(places.begin(), places.end(), [&](glm::vec3 other) {
      return glm::distance(place, other) >= kStartApart;
    });
    if (free) {
      places.push_back(place);
    }
  }
  return places;
}

FaultSpec fault_of(FaultKind kind, std::size_t agents, Chances& chances) {
  const FaultRow& row = fault_row(kind);
  FaultSpec fault;
  fault.kind = kind;
  fault.at = row.place == FaultPlace::kStart ? 0.0 : chances.between(0.8, 1.2);
  fault.length = chances.between(1.5, 2.0);
  fault.size = row.usual_size;
  const double angle = chances.between(0.0, 2.0 * std::numbers::pi);
  fault.direction = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0.0F};
  if (row.target == FaultTarget::kEverybody) {
    fault.agents = {{0, agents}};
    return fault;
  }
  const std::size_t one = chances.below(agents);
  fault.agents = {{one, 1}};
  if (kind == FaultKind::kLinkLost && chances.below(2) == 0) {
    fault.agents = {{0, agents}};  // else it is one of two links
  }
  if (row.target == FaultTarget::kPair) {
    fault.agents.push_back({(one + 1 + chances.below(agents - 1)) % agents, 1});
  }
  return fault;
}

bool strikes(const FaultSpec& fault, std::size_t agent) {
  return std::any_of(fault.agents.begin(), fault.agents.end(), [&](const StruckAgents& struck) {
    return agent >= struck.first && agent < struck.first + struck.count;
  });
}

// Of all whom the row's reaction stops.
std::optional<double> stopped_after(const FaultSpec& fault, const CommandWatch& watch, std::size_t agents) {
  const Severity reaction = fault_row(fault.kind).reaction;
  if (reaction < Severity::kHold) {
    return std::nullopt;
  }
  double latest = 0.0;
  for (std::size_t agent = 0; agent < agents; ++agent) {
    if (reaction != Severity::kHoldAll && !strikes(fault, agent)) {
      continue;
    }
    const auto after = watch.stopped_after(agent, from_seconds(fault.at));
    if (!after) {
      return std::nullopt;
    }
    latest = std::max(latest, *after);
  }
  return latest;
}

// And a few more, for the end.
std::size_t most_ticks(const Scenario& scenario) {
  return static_cast<std::size_t>(scenario.duration * static_cast<double>(scenario.control.rate)) + 10;
}

bool holds(const FaultEvent& event) {
  return event.severity == key_of(Severity::kHold) || event.severity == key_of(Severity::kHoldAll) ||
         event.severity == key_of(Severity::kLand) || event.severity == key_of(Severity::kCut);
}

// The worst of all that the first telling of the fault's symptom is about. Where all are to hold, all are.
std::optional<std::uint64_t> safe_after(const FaultSpec& fault, const CommandWatch& watch,
                                        std::span<const RobotInfo> robots,
                                        const std::vector<FaultEvent>& events) {
  const std::string_view cause = info_of(fault_row(fault.kind).symptom).cause;
  std::optional<std::uint64_t> worst;
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    const auto told = std::find_if(events.begin(), events.end(), [&](const FaultEvent& event) {
      const bool of_all = event.robot.empty() || event.severity == key_of(Severity::kHoldAll);
      return event.time_s >= fault.at && event.cause == cause && holds(event) &&
             (of_all || event.robot == robots[robot].name);
    });
    if (told == events.end()) {
      continue;
    }
    const auto ticks = watch.safe_after(robot, from_seconds(told->time_s) - std::chrono::microseconds(1));
    worst = std::max(worst.value_or(0), ticks.value_or(kNever));
  }
  return worst;
}

// What a guard sees is this old, and is told a tick later.
Time most_delay(const Scenario& scenario) {
  const SimHalSpec& sim = scenario.hals.front().sim;
  return from_seconds(2.0 / static_cast<double>(scenario.control.rate) + static_cast<double>(sim.delay) +
                      1.0 / static_cast<double>(sim.rate));
}

// s from the start to the tick that has the first poses.
double first_pose(const Scenario& scenario) {
  const auto rate = static_cast<double>(scenario.control.rate);
  return std::ceil(static_cast<double>(scenario.hals.front().sim.delay) * rate - 1e-6) / rate;
}

struct Noticed {
  std::optional<double> after;  // s, from when it can be seen
  bool missed = false;
};

// A robot that does not go where it is told can be seen to once it has left its tube, a frozen pose of one
// that is told to move, how robots start as soon as there is a pose; the others as soon as they begin.
Noticed when_noticed(const Scenario& scenario, const FaultSpec& fault, const std::vector<FaultEvent>& events,
                     const GuardWitness& witness) {
  const auto after = noticed_after(scenario, fault, events);
  const std::size_t robot = fault.agents.front().first;
  if (fault_row(fault.kind).place == FaultPlace::kStart && after) {
    return {std::max(0.0, *after - first_pose(scenario)), false};
  }
  if (fault.kind == FaultKind::kPoseFrozen) {
    const double moved = witness.told_to_move(robot, fault.at, fault.at + after.value_or(fault.length));
    return {after ? std::optional(moved) : std::nullopt, !after && moved > kLongFrozen};
  }
  if (fault_row(fault.kind).symptom != Symptom::kTrackingError) {
    return {after, !after};
  }
  const auto left = witness.left_tube(robot, fault.at);
  if (!left) {
    return {after ? std::optional(0.0) : std::nullopt};
  }
  return {after ? std::optional(std::max(0.0, fault.at + *after - *left)) : std::nullopt,
          !after && *left < scenario.duration - 2.0 * to_seconds(most_delay(scenario))};
}

}  // namespace

Result<FaultWorld> make_fault_world() {
  FaultWorld world;
  auto scenario = load_scenario_text(kScenario, "faults.yaml", {});
  if (!scenario) {
    return fail(std::move(scenario.error().front()));
  }
  world.scenario = std::move(*scenario);
  auto ready = prepare(world.scenario, {.threads = 1});
  if (!ready) {
    return fail(std::move(ready.error().front()));
  }
  world.ready = std::move(*ready);
  return world;
}

Result<FaultFlight> fly_with_faults(const FaultWorld& world, const std::vector<FaultKind>& kinds,
                                    std::uint64_t seed) {
  Scenario scenario = world.scenario;
  scenario.seed = seed;
  Chances chances(seed);
  const auto agents = static_cast<std::size_t>(scenario.swarms.front().count);
  const Box start{{0.5F, 0.5F, 0.5F}, {5.5F, 5.5F, 2.5F}};
  const std::vector<glm::vec3> places = start_anywhere(start, agents, chances);
  bool ends_early = false;
  for (const FaultKind kind : kinds) {
    scenario.faults.push_back(fault_of(kind, agents, chances));
    ends_early = ends_early || fault_row(kind).place == FaultPlace::kOperator;
  }
  VirtualClock clock;
  const LimitsSpec& limits = scenario.swarms.front().limits;
  simulate::BreachWatch breaches(simulate::promise_of(scenario));
  const std::size_t ticks = most_ticks(scenario);
  CommandWatch watch(agents, ticks, static_cast<double>(limits.acceleration), breaches);
  GuardWitness witness(watch, breaches, agents, ticks, limits.tube);
  HostileEngine engine(seed, scenario.world.bounds, kTooFast * limits.speed);
  const simulate::Robots robots =
      simulate::make_robots(scenario, places, clock, sim_hal::Backend::kNative, &witness);
  const simulate::Sabotage sabotage(scenario, engine, clock, nullptr);
  const Motion motion(scenario);
  GuardConfig config = guard_config(scenario, world.ready->world, motion, sabotage.clock());
  config.hooks = {};  // of those who watch the flight, one allocates where a promise is broken
  GuardedHal guard(std::move(config), *robots.hal);
  witness.hear(guard);
  const auto summary = fly({.scenario = scenario,
                            .world = world.ready->world,
                            .engine = sabotage.engine(),
                            .hal = *robots.hal,
                            .truth = robots.truth.get(),
                            .clock = sabotage.clock(),
                            .stop = sabotage.stop(),
                            .guard = &guard,
                            .between = [&](GuardPort& port) { return sabotage.before(port); }});
  if (!summary) {
    return fail(summary.error());
  }
  FaultFlight flight;
  flight.breaches = breaches.breaches();
  flight.suspended = witness.suspended(most_delay(scenario));
  flight.least_gap = breaches.least_gap();
  flight.hash = watch.hash();
  const double last_ticks = 3.0 / static_cast<double>(scenario.control.rate);
  flight.hung = !ends_early && summary->simulated_s < scenario.duration - last_ticks;
  for (const FaultSpec& fault : scenario.faults) {
    const Noticed noticed = when_noticed(scenario, fault, summary->faults, witness);
    flight.seen_after.push_back(noticed.after);
    flight.missed.push_back(noticed.missed);
    flight.safe_after.push_back(safe_after(fault, watch, robots.hal->robots(), summary->faults));
    flight.stopped_after.push_back(stopped_after(fault, watch, agents));
  }
  return flight;
}

}  // namespace mayfly::bench
