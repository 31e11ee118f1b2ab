// What moves a swarm, where it is not the field model alone, and who of it is there.
#pragma once

#include <glm/vec3.hpp>

namespace mayfly {

enum class Model { kField, kForces, kBoids, kOrca, kBrownian };  // later: shape, pso

// BSwarm15 §4, Ren16. Zones are radii, 0 <= repulsion <= alignment <= attraction, already scaled to the
// temperature.
struct ForcesSpec {
  float friction = 0.0F;           // 1/m, γ
  float repulsion_weight = 0.0F;   // m/s², χ_rep
  float repulsion_radius = 0.0F;   // m
  float alignment_weight = 0.0F;   // m/s², χ_ali
  float alignment_radius = 0.0F;   // m
  float attraction_weight = 0.0F;  // m/s², χ_att
  float attraction_radius = 0.0F;  // m
  float far_error = 0.0F;          // of attraction, how far off the mean may be; 0: exact
};

// Reynolds 1987. Radii are already scaled to the temperature.
struct BoidsSpec {
  float separation_weight = 0.0F;  // m/s²
  float separation_radius = 0.0F;  // m
  float alignment_weight = 0.0F;   // 1/s
  float alignment_radius = 0.0F;   // m
  float cohesion_weight = 0.0F;    // 1/s²
  float cohesion_radius = 0.0F;    // m
  float speed = 1.0F;              // m/s
};

// Schweitzer 1998: active Brownian particles.
struct BrownianSpec {
  float friction = 0.0F;     // 1/s, γ0
  float intake = 0.0F;       // m²/s³, q
  float dissipation = 0.0F;  // 1/s, c
  float conversion = 0.0F;   // s/m², d
  float noise = 0.0F;        // m/s^1.5, √(2D)
  float pull = 0.0F;         // 1/s², a
  glm::vec3 center{0.0F};    // m
};

// Optimal reciprocal collision avoidance (van den Berg et al. 2011).
struct AvoidanceSpec {
  bool on = false;
  float horizon = 1.0F;       // s, against agents
  float wall_horizon = 0.5F;  // s, against obstacles
  float range = 1.0F;         // m: nobody farther is considered
  int neighbours = 10;        // the nearest so many are
  bool strict = false;        // nobody touches even in a jam
};

// Agents that are not there from the start: those with the highest numbers.
struct JoinSpec {
  int first = 0;      // so many are
  float rate = 1.0F;  // the others come, so many a second, one after the other
};

// Agents that leave, the lowest numbers first.
struct LeaveSpec {
  float after = 0.0F;  // s
  float rate = 1.0F;   // so many a second, one after the other
  int count = 0;
};

}  // namespace mayfly
