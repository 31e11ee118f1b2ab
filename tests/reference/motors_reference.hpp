// The models that the force model is compared with, in double precision: Boids (Reynolds 1987) pair by pair,
// and active Brownian particles (Schweitzer, Ebeling and Tilch 1998). Calls nothing of the code under test.
#pragma once

#include "tests/reference/forces_reference.hpp"

namespace mayfly::reference {

struct Boids {
  double separation_weight = 0, alignment_weight = 0, cohesion_weight = 0;
  double separation = 0, alignment = 0, cohesion = 0;  // m, radii
};

// One agent's acceleration, m/s²: away from the near, faster the nearer; to the mean velocity; to the mean
// place.
inline Vec3 flocking(const Agents& all, std::size_t i, const Boids& b) {
  Vec3 apart{}, velocity{}, place{};
  std::size_t near_ones = 0, aligned = 0, together = 0;
  for (std::size_t j = 0; j < all.r.size(); ++j) {
    const Vec3 line = all.r[j] - all.r[i];
    const double distance = length(line);
    if (j == i) {
      continue;
    }
    if (distance < b.separation) {
      apart = apart - (1 - distance / b.separation) * unit(line);
      ++near_ones;
    }
    if (distance < b.alignment) {
      velocity = velocity + (all.v[j] - all.v[i]);
      ++aligned;
    }
    if (distance < b.cohesion) {
      place = place + line;
      ++together;
    }
  }
  const auto mean = [](double weight, Vec3 sum, std::size_t count) {
    return count == 0 ? Vec3{} : (weight / static_cast<double>(count)) * sum;
  };
  return mean(b.separation_weight, apart, near_ones) + mean(b.alignment_weight, velocity, aligned) +
         mean(b.cohesion_weight, place, together);
}

struct Brownian {
  double friction = 0, intake = 0, dissipation = 0, conversion = 0, pull = 0;
  Vec3 centre{};
};

// dv/dt without its chance: the depot holds q/(c + d v²), and gives d of that times v.
inline Vec3 drift(Vec3 r, Vec3 v, const Brownian& b) {
  const double speed = length(v);
  const double depot = b.intake / (b.dissipation + b.conversion * speed * speed);
  return (b.conversion * depot - b.friction) * v + b.pull * (b.centre - r);
}

}  // namespace mayfly::reference
