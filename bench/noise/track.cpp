#include "bench/noise/track.hpp"

#include <memory>

#include "bench/noise/lanes.hpp"
#include "bench/noise/steering.hpp"
#include "controller/engine/moment.hpp"

namespace mayfly::bench {
namespace {

std::unique_ptr<Steering> make_steering(const Arena& arena, SteeredBy model) {
  switch (model) {
    case SteeredBy::kBoids:
      return make_boids(arena);
    case SteeredBy::kCrowd:
      return make_crowd(arena);
    default:
      return make_path(arena);
  }
}

// The noise alone, bent at walls as our model bends it.
void noise_velocities(const Arena& arena, const kernels::MfField& field, const kernels::MfMoment& moment,
                      std::span<const glm::vec3> at, std::span<glm::vec3> noise) {
  const kernels::MfTables tables = arena.tables();
  for (std::size_t a = 0; a < at.size(); a += MF_LANES) {
    const kernels::F3 r = lanes_of(at, a);
    const kernels::I id = kernels::mf_lane_index() + static_cast<int>(a);
    const kernels::F3 v = kernels::mf_field_velocity(r, id, kernels::mf_isplat(0), &field, &moment, &tables);
    store_lanes(v, noise, a);
  }
}

// No agent flies into a wall, whatever steers it.
void guard(const Arena& arena, std::span<const glm::vec3> at, std::span<glm::vec3> velocity) {
  for (std::size_t a = 0; a < at.size(); a += MF_LANES) {
    const kernels::F3 safe = kernels::mf_field_guard(lanes_of(at, a), lanes_of(velocity, a), &arena.field,
                                                     arena.world.walls.data());
    store_lanes(safe, velocity, a);
  }
}

}  // namespace

Flown fly_model(const Arena& arena, SteeredBy model, NoiseKind noise, std::size_t agents, std::size_t ticks,
                std::uint64_t seed) {
  kernels::MfField still = arena.field;
  still.cruise_speed = 0.0F;
  still.has_noise = noise == NoiseKind::kNone ? 0 : 1;
  still.noise = arena.noise(noise, seed);
  Flown flown;
  flown.agents = agents;
  flown.at = arena.starts(agents, seed);
  flown.at.resize((ticks + 1) * agents);
  flown.noise.resize(ticks * agents);
  if (agents == 0) {
    return flown;
  }
  const auto steering = make_steering(arena, model);
  std::vector<glm::vec3> steered(agents), added(agents), velocity(agents);
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    const auto at = flown.places(tick);
    steering->steer(at, steered);
    const kernels::MfMoment moment = moment_of(still.noise, tick, static_cast<double>(tick) * kPeriod);
    noise_velocities(arena, still, moment, at, added);
    for (std::size_t a = 0; a < agents; ++a) {
      velocity[a] = steered[a] + added[a];
    }
    guard(arena, at, velocity);
    for (std::size_t a = 0; a < agents; ++a) {
      flown.at[(tick + 1) * agents + a] = at[a] + velocity[a] * static_cast<float>(kPeriod);
      flown.noise[tick * agents + a] = velocity[a] - steered[a];
    }
  }
  return flown;
}

}  // namespace mayfly::bench
