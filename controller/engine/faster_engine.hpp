// `--engine auto`: which engine is faster with this swarm, on this machine, now.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"

namespace mayfly {

// s a tick, the least of a few, of an engine that is prepared, for agents at `at`. Infinite where it has a
// fault.
double trial_tick(Engine& engine, const PositionColumns& at, float period_s);

// The fastest of `engines` with these swarms, prepared; the first of equals. An engine that cannot be
// prepared, or fails at its trial, is out; the first one's error comes back if all are.
Result<std::unique_ptr<Engine>> faster_engine(std::vector<std::unique_ptr<Engine>> engines,
                                              std::span<const SwarmModel> swarms, const PositionColumns& at,
                                              float period_s);

}  // namespace mayfly
