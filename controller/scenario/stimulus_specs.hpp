// What single agents answer to.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "controller/scenario/path_spec.hpp"
#include "core/result.hpp"

namespace mayfly {

// A light that agents fly to now and then (Wang14 §6, phototaxis).
struct LampSpec {
  std::string name;
  glm::vec3 position{0.0F};  // m
  float reach = 1.0F;        // m; farther agents do not see it
  // Of a swarm that fields lead:
  float speed = 1.0F;        // m/s toward it, on top of the field
  float probability = 0.0F;  // that an agent answers at a tick
  // Of one that forces drive, to which it is a prey:
  float weight = 0.0F;  // m/s² toward it, χ_res
  std::string swarm;    // empty: all
  Place place;
};

// What drives agents of the force model away or draws them (BSwarm15 §4, F_res).
struct StimulusSpec {
  enum class Kind {
    kPredator,  // they flee it
    kFood,      // they fly straight to it
    kMate,      // the same
    kAhead      // each agent's own, which moves ahead of it
  };
  Kind kind = Kind::kFood;
  std::string name;          // of all but kAhead
  glm::vec3 position{0.0F};  // m, at the start; of all but kAhead
  std::optional<PathSpec> path;
  float reach = 1.0F;     // m, r_res: farther agents do not feel it
  float weight = 1.0F;    // m/s², χ_res
  float distance = 0.0F;  // m ahead, kAhead only
  float turn = 0.0F;      // rad to the left of ahead, kAhead only
  std::string swarm;      // empty: all that forces drive
  Place place;

  // m, at `time_s` (s) after the start. Allocates nothing.
  glm::vec3 position_at(double time_s) const noexcept {
    return path ? position + path->displacement(time_s) : position;
  }
};

}  // namespace mayfly
