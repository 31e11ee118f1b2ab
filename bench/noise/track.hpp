// A flight of one model with one noise.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "bench/noise/arena.hpp"

namespace mayfly::bench {

enum class SteeredBy { kPath, kBoids, kCrowd };

struct Flown {
  std::size_t agents = 0;
  std::vector<glm::vec3> at;     // m, tick by tick, the start included
  std::vector<glm::vec3> noise;  // m/s, tick by tick: what was added to the steering, walls' guard included

  std::size_t ticks() const { return agents == 0 ? 0 : noise.size() / agents; }
  std::span<const glm::vec3> places(std::size_t tick) const {
    return std::span(at).subspan(tick * agents, agents);
  }
  std::span<const glm::vec3> noises(std::size_t tick) const {
    return std::span(noise).subspan(tick * agents, agents);
  }
};

// Minimum distance enforcement is off: what noise does to distances is what is compared.
Flown fly_model(const Arena& arena, SteeredBy model, NoiseKind noise, std::size_t agents, std::size_t ticks,
                std::uint64_t seed);

}  // namespace mayfly::bench
