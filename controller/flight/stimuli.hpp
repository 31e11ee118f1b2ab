// What agents of the force model flee and seek, and where it is as the flight goes on.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/scenario/scenario.hpp"
#include "kernels/forces.h"

namespace mayfly {

// Those that `swarm` feels: lamps, then the others, in the scenario's order.
void add_stimuli(const Scenario& scenario, const SwarmSpec& swarm, kernels::MfForces& forces);

// Puts those that move where they are. Allocates nothing but at the start.
class MovingStimuli {
 public:
  // `scenario` must outlive it.
  explicit MovingStimuli(const Scenario& scenario);

  // s since the flight began.
  void move(double time_s, Engine& engine) noexcept;

 private:
  struct Swarm {
    std::size_t index = 0;
    std::vector<const StimulusSpec*> specs;  // null for one that stands still
    std::vector<glm::vec3> places;           // m
  };
  std::vector<Swarm> swarms_;  // only those to whom something moves
};

// A lamp or another stimulus that has a name; null where there is none of that name.
struct NamedStimulus {
  const StimulusSpec* moving = nullptr;  // null for a lamp
  glm::vec3 position{0.0F};              // m, at the start
  float reach = 0.0F;                    // m

  glm::vec3 at(double time_s) const noexcept { return moving ? moving->position_at(time_s) : position; }
};
std::optional<NamedStimulus> stimulus_named(const Scenario& scenario, const std::string& name);

}  // namespace mayfly
