// A planner's wish, with memory of its own.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "core/hal.hpp"

namespace mayfly::test {

inline constexpr Time kTick = std::chrono::milliseconds(10);

struct WishOf {
  explicit WishOf(std::size_t robots, glm::vec3 velocity = {1.0F, 0.0F, 0.0F})
      : kind(robots, CommandKind::kVelocity),
        vx(robots, velocity.x),
        vy(robots, velocity.y),
        vz(robots, velocity.z) {}
  CommandColumns columns(Time deadline, std::uint64_t sequence) const {
    return {kind, vx, vy, vz, deadline, sequence};
  }
  std::vector<CommandKind> kind;
  std::vector<float> vx, vy, vz;
};

}  // namespace mayfly::test
