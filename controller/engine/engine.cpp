#include "controller/engine/engine.hpp"

#include <algorithm>

namespace mayfly {

void replace(SwarmModel& swarm, const SwarmFields& fields) noexcept {
  if (!fields.walls.empty()) {
    swarm.walls = fields.walls;
  }
  if (!fields.guide.empty()) {
    swarm.guide = fields.guide;
  }
  swarm.field.goal_x = fields.goal_offset.x;
  swarm.field.goal_y = fields.goal_offset.y;
  swarm.field.goal_z = fields.goal_offset.z;
  swarm.field.goal_vx = fields.goal_velocity.x;
  swarm.field.goal_vy = fields.goal_velocity.y;
  swarm.field.goal_vz = fields.goal_velocity.z;
}

void place_stimuli(SwarmModel& swarm, std::span<const glm::vec3> places) noexcept {
  const auto count = std::min(places.size(), static_cast<std::size_t>(swarm.forces.stimuli));
  for (std::size_t s = 0; s < count; ++s) {
    kernels::MfStimulus& stimulus = swarm.forces.stimulus[s];
    stimulus.x = places[s].x;
    stimulus.y = places[s].y;
    stimulus.z = places[s].z;
  }
}

}  // namespace mayfly
