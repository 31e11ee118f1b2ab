#include "simulate/robots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "controller/composite_hal.hpp"
#include "sim_hal/sim_hal.hpp"
#include "simulate/breach_watch.hpp"
#include "simulate/sabotage.hpp"
#include "simulate/twins.hpp"

namespace mayfly::simulate {
namespace {

sim_hal::Plant plant_of(PlantKind kind) {
  switch (kind) {
    case PlantKind::kVelocityLag:
      return sim_hal::Plant::kVelocityLag;
    case PlantKind::kDoubleIntegrator:
      return sim_hal::Plant::kDoubleIntegrator;
    case PlantKind::kIdeal:
      break;
  }
  return sim_hal::Plant::kIdeal;
}

sim_hal::SimHalConfig config_of(const HalSpec& spec, const Scenario& scenario, Clock& clock) {
  sim_hal::SimHalConfig config;
  config.name = spec.name;
  config.plant = plant_of(spec.sim.plant);
  config.time_constant = spec.sim.time_constant;
  config.rate_hz = static_cast<double>(spec.sim.rate);
  config.faults = {spec.sim.pose_noise, spec.sim.delay,       spec.sim.dropout,
                   spec.sim.freeze,     spec.sim.freeze_time, spec.sim.nan};
  config.endurance = spec.sim.endurance;
  config.links = spec.sim.links;
  config.seed = scenario.seed;
  config.lock_step = clock.is_virtual();
  config.clock = &clock;
  return config;
}

std::string name_of(const SwarmSpec& swarm, std::size_t agent) {
  return fmt::format("{}_{}", swarm.name, agent);
}

void add_swarm(sim_hal::SimHalConfig& config, const SwarmSpec& swarm, float floor,
               std::span<const glm::vec3> positions) {
  config.ground = std::max(config.ground, floor + swarm.radius);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    config.robot_names.push_back(name_of(swarm, i));
    config.positions.push_back(positions[i]);
    config.max_speed.push_back(swarm.limits.speed);
    config.max_acceleration.push_back(swarm.limits.acceleration);
  }
}

std::optional<sim_hal::Effect> effect_of(FaultKind kind) {
  using sim_hal::Effect;
  constexpr std::array kEffects{std::pair{FaultKind::kLinkLost, Effect::kLinkLost},
                                std::pair{FaultKind::kRobotSilent, Effect::kSilent},
                                std::pair{FaultKind::kLinkDegraded, Effect::kLinkLoss},
                                std::pair{FaultKind::kLinkLatency, Effect::kLinkLatency},
                                std::pair{FaultKind::kPoseGhost, Effect::kPoseGhost},
                                std::pair{FaultKind::kPoseStale, Effect::kPoseStale},
                                std::pair{FaultKind::kPoseFrozen, Effect::kPoseFrozen},
                                std::pair{FaultKind::kPoseNan, Effect::kPoseNan},
                                std::pair{FaultKind::kPoseJump, Effect::kPoseJump},
                                std::pair{FaultKind::kIdSwap, Effect::kIdSwap},
                                std::pair{FaultKind::kWind, Effect::kWind},
                                std::pair{FaultKind::kWeakMotor, Effect::kWeakMotor},
                                std::pair{FaultKind::kBatteryLow, Effect::kBatteryLow},
                                std::pair{FaultKind::kBatteryCritical, Effect::kBatteryLow},
                                std::pair{FaultKind::kBatteryJump, Effect::kBatteryJump},
                                std::pair{FaultKind::kBatteryNan, Effect::kBatteryNan},
                                std::pair{FaultKind::kSimulationFailed, Effect::kSimulationFails}};
  const auto* const found =
      std::find_if(kEffects.begin(), kEffects.end(), [&](const auto& e) { return e.first == kind; });
  return found == kEffects.end() ? std::nullopt : std::optional(found->second);
}

// What of the scenario's faults strikes the robots of a HAL: the agents [first, first + count).
std::vector<sim_hal::ScriptedFault> script_of(const Scenario& scenario, std::size_t first,
                                              std::size_t count) {
  std::vector<sim_hal::ScriptedFault> script;
  for (const FaultSpec& fault : scenario.faults) {
    const auto effect = effect_of(fault.kind);
    if (!effect) {
      continue;
    }
    sim_hal::ScriptedFault scripted;
    scripted.effect = *effect;
    scripted.from = from_seconds(fault.at);
    scripted.until = std::isfinite(fault.length) ? from_seconds(fault.at + fault.length) : Time::max();
    scripted.size = static_cast<float>(fault.size);
    scripted.direction = fault.direction;
    for (const StruckAgents& range : fault.agents) {
      const std::size_t from = std::max(range.first, first);
      const std::size_t to = std::min(range.first + range.count, first + count);
      if (from < to) {
        scripted.robots.push_back(
            {static_cast<RobotIndex>(from - first), static_cast<RobotIndex>(to - from)});
      }
    }
    if (!scripted.robots.empty()) {
      script.push_back(std::move(scripted));
    }
  }
  return script;
}

const HalSpec& spec_of(const Scenario& scenario, const std::string& name) {
  // The loader has checked that it is there.
  return *std::find_if(scenario.hals.begin(), scenario.hals.end(),
                       [&](const HalSpec& hal) { return hal.name == name; });
}

class SimTruth final : public GroundTruth {
 public:
  SimTruth(std::vector<sim_hal::SimHal*> hals, std::unique_ptr<BreachWatch> watch)
      : hals_(std::move(hals)), watch_(std::move(watch)) {}

  std::optional<BreachSummary> breaches() const noexcept override {
    if (watch_ == nullptr) {
      return std::nullopt;
    }
    const BreachCounts& counts = watch_->breaches();
    return BreachSummary{counts[0], counts[1], counts[2], counts[3]};
  }

  void truth(const StateColumns& to) const noexcept override {
    std::size_t first = 0;
    for (sim_hal::SimHal* hal : hals_) {
      const sim_hal::PoseView from = hal->truth();
      const std::array<std::span<float>, 6> columns{to.x, to.y, to.z, to.vx, to.vy, to.vz};
      const std::size_t count = from.columns[0].size();
      for (std::size_t c = 0; c < columns.size(); ++c) {
        std::copy(from.columns[c].begin(), from.columns[c].end(),
                  columns[c].begin() + static_cast<std::ptrdiff_t>(first));
      }
      std::fill_n(to.stamp.begin() + static_cast<std::ptrdiff_t>(first), count, from.stamp);
      std::fill_n(to.valid.begin() + static_cast<std::ptrdiff_t>(first), count, std::uint8_t{1});
      first += count;
    }
  }

 private:
  std::vector<sim_hal::SimHal*> hals_;
  std::unique_ptr<BreachWatch> watch_;  // null where nobody asks
};

// It looks at every two at every step: only where somebody asks, and where one HAL steps all at once.
bool wants_watch(const Scenario& scenario, std::size_t hals, const Clock& clock) {
  return hals == 1 && clock.is_virtual() &&
         std::any_of(scenario.expect.begin(), scenario.expect.end(), [](const Expectation& expectation) {
           return expectation.quantity == Expectation::Quantity::kSafetyBreaches;
         });
}

}  // namespace

std::vector<RobotInfo> robot_names(const Scenario& scenario) {
  std::vector<RobotInfo> robots;
  std::size_t first = 0;  // of the HAL's
  for (std::size_t s = 0; s < scenario.swarms.size(); ++s) {
    const SwarmSpec& swarm = scenario.swarms[s];
    for (int i = 0; i < swarm.count; ++i) {
      robots.push_back({name_of(swarm, static_cast<std::size_t>(i)), swarm.robots});
    }
    const bool is_last = s + 1 == scenario.swarms.size() || scenario.swarms[s + 1].robots != swarm.robots;
    const std::size_t count = robots.size() - first;
    for (std::size_t i = 0; i < count && is_last; ++i) {
      robots[first + i].link =
          sim_hal::link_name(swarm.robots, spec_of(scenario, swarm.robots).sim.links, i, count);
    }
    first = is_last ? robots.size() : first;
  }
  return robots;
}

Robots make_robots(const Scenario& scenario, const std::vector<glm::vec3>& places, Clock& clock,
                   sim_hal::Backend backend, sim_hal::StepWatcher* watcher) {
  const std::vector<glm::vec3> positions = start_places(scenario, places);
  // Neighbouring swarms of one HAL share it; the order of robots is the order of agents.
  std::vector<sim_hal::SimHalConfig> configs;
  std::size_t first = 0;
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (configs.empty() || configs.back().name != swarm.robots) {
      configs.push_back(config_of(spec_of(scenario, swarm.robots), scenario, clock));
    }
    const auto count = static_cast<std::size_t>(swarm.count);
    add_swarm(configs.back(), swarm, scenario.world.bounds.min.z, std::span(positions).subspan(first, count));
    first += count;
  }
  std::unique_ptr<BreachWatch> own_watch;
  if (watcher == nullptr && wants_watch(scenario, configs.size(), clock)) {
    own_watch = std::make_unique<BreachWatch>(promise_of(scenario));
    watcher = own_watch.get();
  }
  first = 0;
  for (sim_hal::SimHalConfig& config : configs) {
    config.watcher = watcher;
    config.script = script_of(scenario, first, config.positions.size());
    first += config.positions.size();
  }
  std::vector<sim_hal::SimHal*> sims;
  std::vector<std::unique_ptr<Hal>> hals;
  for (sim_hal::SimHalConfig& config : configs) {
    config.backend = backend;
    auto hal = std::make_unique<sim_hal::SimHal>(std::move(config));
    sims.push_back(hal.get());
    hals.push_back(std::move(hal));
  }
  Robots robots;
  robots.hal = hals.size() == 1 ? std::move(hals.front())
                                : std::make_unique<CompositeHal>("composite", std::move(hals));
  if (clock.is_virtual()) {
    robots.truth = std::make_unique<SimTruth>(std::move(sims), std::move(own_watch));
  }
  add_twins(scenario, robots);
  return robots;
}

}  // namespace mayfly::simulate
