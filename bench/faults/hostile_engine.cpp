#include "bench/faults/hostile_engine.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace mayfly::bench {
namespace {

constexpr double kPhase = 0.6;  // s

std::uint64_t mixed(std::uint64_t z) {  // SplitMix64 (Steele et al. 2014)
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

glm::vec3 place_of(const AgentColumns& at, std::size_t agent) {
  return {at.x[agent], at.y[agent], at.z[agent]};
}

}  // namespace

glm::vec3 HostileEngine::chance(std::uint64_t what, std::uint64_t who) const noexcept {
  const std::uint64_t start = mixed(seed_ + 0x9E3779B97F4A7C15U * (what + 1)) + who * 0xD1B54A32D192ED03U;
  glm::vec3 unit(0.0F);
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t bits = mixed(start + static_cast<std::uint64_t>(axis + 1) * 0x9E3779B97F4A7C15U);
    unit[axis] = static_cast<float>(static_cast<double>(bits >> 40U) * 0x1p-24);
  }
  return unit;
}

glm::vec3 HostileEngine::wanted(const AgentColumns& at, std::size_t agent,
                                const TickTime& tick) const noexcept {
  const auto phase = static_cast<std::uint64_t>(tick.time_s / kPhase);
  const glm::vec3 size = world_.max - world_.min;
  const glm::vec3 here = place_of(at, agent);
  switch (static_cast<int>(4.0F * chance(phase, 1'000'000).x)) {
    case 0:
      return world_.min + chance(phase, agent) * size - here;
    case 1:
      return world_.min + 0.5F * size - here;
    case 2: {
      glm::vec3 nearest(0.0F);
      for (std::size_t other = 0; other < at.x.size(); ++other) {
        const glm::vec3 way = place_of(at, other) - here;
        if (other != agent && (nearest == glm::vec3(0.0F) || glm::length(way) < glm::length(nearest))) {
          nearest = way;
        }
      }
      return nearest;
    }
    default:
      return chance(1000 + tick.number, agent) - 0.5F;
  }
}

TickCounts HostileEngine::compute(const AgentColumns& at, const TickTime& tick,
                                  const VelocityColumns& out) noexcept {
  for (std::size_t agent = 0; agent < at.x.size(); ++agent) {
    const glm::vec3 way = wanted(at, agent, tick);
    const float length = glm::length(way);
    const glm::vec3 velocity = length > 0.0F ? way * (speed_ / length) : glm::vec3(0.0F);
    out.x[agent] = velocity.x;
    out.y[agent] = velocity.y;
    out.z[agent] = velocity.z;
  }
  return {};
}

}  // namespace mayfly::bench
