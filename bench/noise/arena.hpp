// Where the models are compared: Wang14's two blocks with their passage, 300 agents, the paper's noise (§7.1,
// Table 1).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "controller/flight/world.hpp"
#include "controller/scenario/scenario.hpp"
#include "kernels/field.h"

namespace mayfly::bench {

inline constexpr double kPeriod = 0.01;     // s, a tick
inline constexpr double kSeparation = 0.2;  // m, d_min: measured, not enforced

struct Arena {
  Scenario scenario;
  World world;
  kernels::MfField field{};  // our path field, without noise

  // For the kernels. Nobody flies long enough to need a place of its own: there is one, of agent 0.
  kernels::MfTables tables() const;

  // The seed draws the starts and the noise.
  std::vector<glm::vec3> starts(std::size_t agents, std::uint64_t seed) const;
  kernels::MfNoise noise(NoiseKind kind, std::uint64_t seed) const;
};

tl::expected<Arena, std::vector<Error>> make_arena();

}  // namespace mayfly::bench
