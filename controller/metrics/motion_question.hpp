// What may be asked about a swarm's motion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>

#include "controller/metrics/last_seen.hpp"

namespace mayfly {

struct MotionQuestion {
  enum class Kind {
    kNone,          // not about motion: its answer stays empty
    kCentreDrift,   // m, the farthest that the centre was from where it was first seen
    kDistance,      // m, mean distance to `place`, over agents and the flight's second half
    kTurns,         // mean over agents of |turns| about the vertical axis through `place`
    kSpread,        // m, radius of gyration, √(mean |r − centre|²), mean of the flight's last tenth
    kPolarisation,  // |mean v̂|, mean of the flight's second half
    kMilling,       // |mean (r × v)_z / |r||v||| about the centre, mean of the flight's second half
    kNearest,       // m, mean distance to the nearest, over agents and the flight's second half
    kArrived,       // share of the agents within `within` of `place`, at `at_tick`
    kClearing,      // m, the least distance of any agent to `place` at any tick
    // An encounter begins when somebody is first within `within` of `place`:
    kParting,  // the largest radius of gyration from then on, by that then
    kClosing   // that of the flight's last tenth, by the same
  };
  Kind kind = Kind::kNone;
  std::size_t first = 0;  // of the swarm's agents
  std::size_t count = 0;

  AgentRange agents() const { return {first, count}; }

  // m, where it is now: kDistance, kTurns and what follows kNearest. Must not throw, and allocates nothing.
  std::function<glm::dvec3()> place{};
  double within = 0.0;                                                // m
  std::uint64_t at_tick = std::numeric_limits<std::uint64_t>::max();  // or the last, where that comes first
};

}  // namespace mayfly
