#include "controller/flight/swarm_models.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "controller/flight/kernel_parts.hpp"
#include "controller/flight/motor_models.hpp"
#include "controller/flight/rest_places.hpp"
#include "controller/flight/scatter.hpp"

namespace mayfly {
namespace {

constexpr std::uint32_t kNoiseStream = 0x4015E000U;

// Sweeps that are done before a crowd is quite parted leave a little of each overlap.
constexpr float kSweepMargin = 1.002F;
// Of its greatest speed an agent is led with so much; the rest is left for making room to others.
constexpr float kLedShare = 0.9F;
// An agent slows down over the way that it cruises in this time, s.
constexpr float kSlowDown = 3.0F;

std::optional<HalSpec> hal_of(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = std::find_if(scenario.hals.begin(), scenario.hals.end(),
                                [&](const HalSpec& spec) { return spec.name == swarm.robots; });
  return hal == scenario.hals.end() ? std::nullopt : std::optional(*hal);
}

kernels::MfGrid kernel_grid(const World& world) {
  const Grid& grid = world.grid;
  const glm::ivec3 cells = world.nested ? world.nested->coarse.cells : grid.cells;
  return {grid.origin.x, grid.origin.y, grid.origin.z, grid.cell,           1.0F / grid.cell,
          cells.x,       cells.y,       cells.z,       world.nested ? 1 : 0};
}

// m²/s², in the mean: a potential of scale and gain 1 has a curl of 1.718 m/s rms (model.md §1), octaves are
// independent.
float noise_speed_squared(const NoiseSpec& noise) {
  float sum = 0.0F;
  for (const NoiseSpec::Octave& octave : noise.octaves) {
    const float speed = 1.718F * octave.gain / octave.scale;
    sum += speed * speed;
  }
  return noise.kind == NoiseKind::kNone ? 0.0F : sum;
}

// By how much two robots may come nearer than the points that are steered, m. One that lags by τ trails its
// point: two by up to τ times their relative velocity. Of two that accelerate no faster than a, each needs
// v²/2a to stop before the other. The typical speed stands for velocities, with the noise's where they turn.
float trailing_margin(const Scenario& scenario, const SwarmSpec& swarm, bool in_real_time) {
  const auto hal = hal_of(scenario, swarm);
  const bool turns_slowly = swarm.governor || (hal && hal->sim.plant == PlantKind::kDoubleIntegrator);
  const float speed = typical_speed(swarm);
  const float noise = swarm.is_guided() ? noise_speed_squared(swarm.noise) : 0.0F;
  const float speed_squared = speed * speed + noise;
  const float to_turn = turns_slowly ? speed_squared / swarm.limits.acceleration : 0.0F;
  const float latency = in_real_time ? realtime_latency(scenario, swarm) : 0.0F;
  return std::max((response_time(scenario, swarm) + latency) * speed, to_turn);
}

// Positions lie some hundred metres from the origin, and rounding there must not eat a distance.
float margin_of(const Scenario& scenario, const SwarmSpec& swarm, bool in_real_time) {
  const Box& b = scenario.world.bounds;
  const float farthest = std::max({std::fabs(b.min.x), std::fabs(b.min.y), std::fabs(b.min.z),
                                   std::fabs(b.max.x), std::fabs(b.max.y), std::fabs(b.max.z)});
  const float rounding = 8.0F * (std::nextafter(farthest, INFINITY) - farthest);
  return rounding + trailing_margin(scenario, swarm, in_real_time);
}

// What MDE keeps, so that `separation` comes of it.
float enforced_distance(const SwarmSpec& swarm, float margin) {
  return swarm.limits.separation > 0.0F ? swarm.limits.separation * kSweepMargin + margin : 0.0F;
}

// The deepest place of the goal, m from its surface: the guide holds minus the depth there.
float goal_depth(const fields::CostField& cost) {
  float least = 0.0F;
  cost.for_each_cell([&](std::size_t cell, glm::vec3, float) {
    if (cost.kind[cell] == fields::CellKind::kReached) {
      least = std::min(least, cost.guide[4 * cell + 3]);
    }
  });
  return -least;
}

// None for a swarm that comes to rest. The loader has seen to it that the others' goals are boxes or spheres.
kernels::MfFence fence_of(const Scenario& scenario, const SwarmSpec& swarm) {
  kernels::MfFence fence{};
  const auto goal = std::find_if(scenario.world.goals.begin(), scenario.world.goals.end(),
                                 [&](const GoalSpec& spec) { return spec.name == swarm.goal; });
  if (!swarm.is_guided() || swarm.at_goal == AtGoal::kRest || goal == scenario.world.goals.end()) {
    return fence;
  }
  glm::vec3 center{0.0F};
  glm::vec3 half{0.0F};
  if (const auto* sphere = std::get_if<fields::SphereShape>(&goal->shape)) {
    fence.kind = MF_FENCE_SPHERE;
    center = sphere->center;
    half = glm::vec3(sphere->radius);
  } else if (const auto* box = std::get_if<fields::BoxShape>(&goal->shape)) {
    fence.kind = MF_FENCE_BOX;
    center = 0.5F * (box->box.min + box->box.max);
    half = 0.5F * (box->box.max - box->box.min);
  }
  fence.x = center.x;
  fence.y = center.y;
  fence.z = center.z;
  fence.half_x = half.x;
  fence.half_y = half.y;
  fence.half_z = half.z;
  return fence;
}

kernels::MfField kernel_field(const Scenario& scenario, const SwarmSpec& swarm, const World& world,
                              float depth, const kernels::MfNoise& noise) {
  kernels::MfField field{};
  field.grid = kernel_grid(world);
  field.noise = noise;
  field.has_noise = swarm.noise.kind == NoiseKind::kNone ? 0 : 1;
  field.has_walls = world.solid.empty() && world.moving.empty() ? 0 : 1;
  field.boundary = swarm.boundary.value_or(world.grid.cell);
  field.cruise_speed = swarm.cruise_speed;
  field.most_speed = kLedShare * swarm.limits.speed;
  field.slow_down = swarm.cruise_speed * kSlowDown;
  field.fence = fence_of(scenario, swarm);
  field.goal_margin = std::max(std::min(0.5F * world.grid.cell, 0.25F * depth), 1e-3F);
  field.radius = swarm.radius;
  field.approach_rate = approach_rate(scenario);
  const glm::vec3 low = scenario.world.bounds.min + swarm.radius;
  const glm::vec3 high = scenario.world.bounds.max - swarm.radius;
  field.low_x = low.x;
  field.low_y = low.y;
  field.low_z = low.z;
  field.high_x = high.x;
  field.high_y = high.y;
  field.high_z = high.z;
  field.wall_reach = wall_reach(scenario, swarm, world.grid.cell);
  add_pulls(scenario, swarm, field);
  return field;
}

SwarmModels::Places rest_columns(const Scenario& scenario, const World& world, std::uint32_t swarm) {
  SwarmModels::Places columns;
  for (const glm::vec3 place : rest_places(scenario, world, swarm)) {
    columns.x.push_back(place.x);
    columns.y.push_back(place.y);
    columns.z.push_back(place.z);
  }
  return columns;
}

}  // namespace

float approach_rate(const Scenario& scenario) {
  constexpr float kFastest = 5.0F;  // 1/s
  return std::min(kFastest, 0.25F * scenario.decision_rate());
}

float wall_reach(const Scenario& scenario, const SwarmSpec& swarm, float cell) {
  const float slowing =
      std::max(1.0F / approach_rate(scenario), swarm.avoidance.on ? swarm.avoidance.wall_horizon : 0.0F);
  return std::max(swarm.boundary.value_or(cell) + cell, swarm.radius + swarm.limits.speed * slowing);
}

float response_time(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = hal_of(scenario, swarm);
  return hal ? hal->sim.delay + (hal->sim.plant == PlantKind::kVelocityLag ? hal->sim.time_constant : 0.0F)
             : 0.0F;
}

Follows follows(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = hal_of(scenario, swarm);
  return hal && hal->sim.plant == PlantKind::kIdeal ? Follows::kAtOnce : Follows::kAccelerating;
}

float realtime_latency(const Scenario& scenario, const SwarmSpec& swarm) {
  const auto hal = hal_of(scenario, swarm);
  return 1.0F / scenario.decision_rate() + (hal ? 1.0F / hal->sim.rate : 0.0F);
}

SwarmModels make_swarm_models(const Scenario& scenario, const World& world, bool in_real_time) {
  using SteadyClock = std::chrono::steady_clock;
  SwarmModels models;
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < scenario.swarms.size(); ++s) {
    const SwarmSpec& spec = scenario.swarms[s];
    const fields::CostField* cost = world.costs[s].get();
    models.rest.push_back(cost ? rest_columns(scenario, world, s) : SwarmModels::Places{});
    const auto start = SteadyClock::now();
    const kernels::MfNoise noise =
        kernel_noise(spec.noise, draw_words({scenario.seed, kNoiseStream, s, 0, 0})[0]);
    models.noise_s += std::chrono::duration<double>(SteadyClock::now() - start).count();
    SwarmModel model;
    model.first = first;
    model.count = static_cast<std::size_t>(spec.count);
    model.field = kernel_field(scenario, spec, world, cost ? goal_depth(*cost) : 0.0F, noise);
    model.walls = world.walls;
    model.guide = cost ? std::span<const float>(cost->guide) : std::span<const float>();
    const float margin = margin_of(scenario, spec, in_real_time);
    set_motor(scenario, spec, model);
    model.avoidance = kernel_avoidance(spec, margin, model.field.most_speed);
    model.separation = enforced_distance(spec, margin);
    model.mde_sweeps = spec.mde_sweeps;
    models.swarms.push_back(model);
    first += model.count;
  }
  for (std::size_t s = 0; s < models.swarms.size(); ++s) {
    models.swarms[s].rest = {models.rest[s].x, models.rest[s].y, models.rest[s].z};
  }
  return models;
}

}  // namespace mayfly
