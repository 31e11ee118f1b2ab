#include "simulate/twins.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "controller/twin/twin_exchange.hpp"

namespace mayfly::simulate {
namespace {

class TwinTruth final : public GroundTruth {
 public:
  TwinTruth(std::unique_ptr<GroundTruth> robots, const TwinHal& twins)
      : robots_(std::move(robots)), twins_(twins) {}

  void truth(const StateColumns& columns) const noexcept override {
    robots_->truth(columns);
    twins_.show_twins(columns);
  }

 private:
  std::unique_ptr<GroundTruth> robots_;
  const TwinHal& twins_;
};

// s: the time constant of robots that follow their commands as a lag; 0 of the others.
float plant_lag(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = std::find_if(scenario.hals.begin(), scenario.hals.end(),
                                [&](const HalSpec& spec) { return spec.name == swarm.robots; });
  return hal->sim.plant == PlantKind::kVelocityLag ? hal->sim.time_constant : 0.0F;
}

}  // namespace

void add_twins(const Scenario& scenario, Robots& robots) {
  if (scenario.twins.empty()) {
    return;
  }
  TwinConfig config;
  std::vector<float> braking;
  std::vector<float> response;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    config.robots.insert(config.robots.end(), count,
                         {swarm.limits.speed, swarm.limits.acceleration, plant_lag(scenario, swarm)});
    braking.insert(braking.end(), count, swarm.limits.braking);
    response.insert(response.end(), count, swarm.limits.latency + plant_lag(scenario, swarm));
  }
  std::vector<TwinSpell> spells;
  for (const TwinSpec& twin : scenario.twins) {
    spells.push_back({static_cast<RobotIndex>(twin.agent), from_seconds(twin.from),
                      std::isfinite(twin.until) ? from_seconds(twin.until) : Time::max()});
  }
  auto hal = std::make_unique<TwinHal>(std::move(robots.hal), std::move(config));
  robots.exchange =
      std::make_unique<TwinExchange>(*hal, std::move(spells), std::move(braking), std::move(response));
  if (robots.truth) {
    robots.truth = std::make_unique<TwinTruth>(std::move(robots.truth), *hal);
  }
  robots.hal = std::move(hal);
}

}  // namespace mayfly::simulate
