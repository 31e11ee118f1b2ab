// From a scenario and its world to what an engine flies by.
#pragma once

#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/flight/world.hpp"
#include "controller/governor/governor_config.hpp"
#include "controller/scenario/scenario.hpp"

namespace mayfly {

// The swarms' models, and the columns that belong to them.
struct SwarmModels {
  struct Places {
    std::vector<float> x, y, z;  // m, one an agent
  };
  std::vector<SwarmModel> swarms;
  std::vector<Places> rest;  // one a swarm
  double noise_s =
      0.0;  // how long the noise took to set up: it is evaluated where agents are, and tabulates nothing

  std::size_t agents() const { return swarms.empty() ? 0 : swarms.back().first + swarms.back().count; }
};

// How fast an agent may near a wall, as a share of its clearance each second: a command that holds for a
// period T never carries it past the wall if that is at most 1/(4T).
float approach_rate(const Scenario& scenario);

// m: further out than this nothing of a wall is felt. `cell`: of the grid, m.
float wall_reach(const Scenario& scenario, const SwarmSpec& swarm, float cell);

// How long a swarm's robots take to fly as they are told, s: the lag of their velocity and the age of what is
// known of them.
float response_time(const Scenario& scenario, const SwarmSpec& swarm);

// How its robots get to the velocity that they are told.
Follows follows(const Scenario& scenario, const SwarmSpec& swarm);

// On the real clock, control and a simulated robot each act on what the other did up to a period ago, s.
float realtime_latency(const Scenario& scenario, const SwarmSpec& swarm);

// Spans point into `world`, which must outlive the result.
SwarmModels make_swarm_models(const Scenario& scenario, const World& world, bool in_real_time = false);

}  // namespace mayfly
