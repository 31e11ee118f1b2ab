// What steers agents before noise is added: our path field, and the two models that Wang14 §7.1 compares it
// with.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "bench/noise/arena.hpp"

namespace mayfly::bench {

class Steering {
 public:
  virtual ~Steering() = default;
  // The velocity (m/s) of each agent at `at` (m) for the next tick.
  virtual void steer(std::span<const glm::vec3> at, std::span<glm::vec3> velocity) = 0;
};

// Down the cost field at cruise speed: our model.
std::unique_ptr<Steering> make_path(const Arena& arena);

// Reynolds 1987 and 1999: separation, alignment and cohesion, and following the flow of the same path field,
// each a wish whose weighted sum an agent obeys as far as its acceleration allows.
std::unique_ptr<Steering> make_boids(const Arena& arena);

// After Treuille 2006, in three dimensions and as simple as it goes: where agents are dense they are slower,
// and a way is dearer; a potential is solved on a grid for the whole crowd twice a second, and all fly down
// it. The velocity field is compressible.
std::unique_ptr<Steering> make_crowd(const Arena& arena);

// The guided velocity of our path field, eight agents at a time.
void guided_velocities(const Arena& arena, std::span<const glm::vec3> at, std::span<glm::vec3> velocity);

}  // namespace mayfly::bench
