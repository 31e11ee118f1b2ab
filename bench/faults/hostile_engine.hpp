// A planner that no swarm should have: it sends robots to places of chance, all to one point, each after its
// nearest, and this way and that, faster than they can.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "controller/engine/engine.hpp"
#include "core/grid.hpp"

namespace mayfly::bench {

class HostileEngine final : public Engine {
 public:
  HostileEngine(std::uint64_t seed, const Box& world, float speed)
      : seed_(seed), world_(world), speed_(speed) {}

  std::string_view name() const noexcept override { return "hostile"; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override { return {}; }
  TickCounts compute(const AgentColumns& at, const TickTime& tick,
                     const VelocityColumns& out) noexcept override;
  void move_stimuli(std::size_t, std::span<const glm::vec3>) noexcept override {}
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}

 private:
  glm::vec3 chance(std::uint64_t what, std::uint64_t who) const noexcept;  // in [0, 1)³
  glm::vec3 wanted(const AgentColumns& at, std::size_t agent, const TickTime& tick) const noexcept;

  std::uint64_t seed_;
  Box world_;
  float speed_;  // m/s
};

}  // namespace mayfly::bench
