#include "controller/flight/swarm_models.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

constexpr std::uint32_t kNoiseStream = 0x4015E000U;
constexpr std::uint32_t kSettleStream = 0x5E771E00U;

// The share of a goal's depth at which agents come to rest: none on its very face, where it would not count
// as inside.
constexpr float kShallowest = 0.3F;
constexpr float kDeepest = 0.95F;
// An agent slows down over the way that it cruises in this time, s, or over the goal's depth if that is less.
constexpr float kSlowDown = 1.0F;

std::uint32_t word(std::uint64_t seed, std::uint32_t swarm, std::uint32_t agent, std::uint32_t stream) {
  const r123::Philox4x32::ctr_type counter{{agent, 0, swarm, stream}};
  const r123::Philox4x32::key_type key{
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}};
  return r123::Philox4x32()(counter, key)[0];
}

kernels::MfGrid kernel_grid(const Grid& grid) {
  return {grid.origin.x,    grid.origin.y, grid.origin.z, grid.cell,
          1.0F / grid.cell, grid.cells.x,  grid.cells.y,  grid.cells.z};
}

kernels::MfNoise kernel_noise(const NoiseSpec& spec, std::uint32_t seed) {
  kernels::MfNoise noise{};
  noise.octaves = static_cast<int>(std::min<std::size_t>(spec.octaves.size(), MF_MAX_OCTAVES));
  noise.permuted = spec.hash == NoiseHash::kPerlin2002 ? 1 : 0;
  noise.seed = seed;
  for (std::size_t o = 0; o < static_cast<std::size_t>(noise.octaves); ++o) {
    noise.inverse_scale[o] = 1.0F / spec.octaves[o].scale;
    noise.gain[o] = spec.octaves[o].gain;
  }
  return noise;
}

// How fast an agent may near a wall, as a share of its clearance each second. A first-order lag of τ never
// passes the wall if the rate is at most 1/(4τ) (the pair is then over-damped); a sampled command, if it is
// at most 1/(4T).
float approach_rate(const Scenario& scenario, const SwarmSpec& swarm) {
  float response_s = 1.0F / scenario.control.rate;
  for (const HalSpec& hal : scenario.hals) {
    if (hal.name == swarm.robots && hal.sim.plant == PlantKind::kVelocityLag) {
      response_s += hal.sim.time_constant;
    }
    if (hal.name == swarm.robots) {
      response_s += hal.sim.delay;
    }
  }
  constexpr float kFastest = 5.0F;  // 1/s
  return std::min(kFastest, 0.25F / response_s);
}

// The positions of a fast world lie some hundred metres from the origin: rounding there must not eat the
// separation.
float separation_with_rounding(const Scenario& scenario, float separation) {
  const Box& b = scenario.world.bounds;
  const float farthest = std::max({std::fabs(b.min.x), std::fabs(b.min.y), std::fabs(b.min.z),
                                   std::fabs(b.max.x), std::fabs(b.max.y), std::fabs(b.max.z)});
  return separation > 0.0F ? separation + 8.0F * (std::nextafter(farthest, INFINITY) - farthest) : 0.0F;
}

// The deepest place of the goal, m from its surface: the guide holds minus the depth there.
float goal_depth(const fields::CostField& cost) {
  float least = 0.0F;
  for (std::size_t cell = 0; cell < cost.kind.size(); ++cell) {
    if (cost.kind[cell] == fields::CellKind::kReached) {
      least = std::min(least, cost.guide[4 * cell + 3]);
    }
  }
  return -least;
}

kernels::MfField kernel_field(const Scenario& scenario, const SwarmSpec& swarm, const World& world,
                              float depth, std::uint32_t noise_seed) {
  kernels::MfField field{};
  field.grid = kernel_grid(world.grid);
  field.noise = kernel_noise(swarm.noise, noise_seed);
  field.has_noise = swarm.noise.kind == NoiseKind::kCurl ? 1 : 0;
  field.has_walls = world.solid.empty() ? 0 : 1;
  field.boundary = swarm.boundary.value_or(world.grid.cell);
  field.cruise_speed = swarm.cruise_speed;
  field.slow_down = std::max(std::min(swarm.cruise_speed * kSlowDown, depth), 1e-3F);
  field.radius = swarm.radius;
  field.approach_rate = approach_rate(scenario, swarm);
  field.wall_reach =
      std::max(field.boundary + world.grid.cell, swarm.radius + swarm.limits.speed / field.approach_rate);
  return field;
}

}  // namespace

SwarmModels make_swarm_models(const Scenario& scenario, const World& world) {
  SwarmModels models;
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < scenario.swarms.size(); ++s) {
    const SwarmSpec& spec = scenario.swarms[s];
    const fields::CostField& cost = *world.costs[s];
    const float depth = goal_depth(cost);
    std::vector<float>& settle = models.settle.emplace_back();
    for (std::uint32_t agent = 0; agent < static_cast<std::uint32_t>(spec.count); ++agent) {
      const float share = static_cast<float>(word(scenario.seed, s, agent, kSettleStream) >> 8U) * 0x1p-24F;
      settle.push_back(depth * (kShallowest + share * (kDeepest - kShallowest)));
    }
    SwarmModel model;
    model.first = first;
    model.count = static_cast<std::size_t>(spec.count);
    model.field = kernel_field(scenario, spec, world, depth, word(scenario.seed, s, 0, kNoiseStream));
    model.walls = world.walls;
    model.guide = cost.guide;
    model.separation = separation_with_rounding(scenario, spec.limits.separation);
    model.mde_sweeps = spec.mde_sweeps;
    models.swarms.push_back(model);
    first += model.count;
  }
  for (std::size_t s = 0; s < models.swarms.size(); ++s) {
    models.swarms[s].settle = models.settle[s];
  }
  return models;
}

}  // namespace mayfly
