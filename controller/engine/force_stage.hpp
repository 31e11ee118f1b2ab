// The stage of a tick that integrates forces (kernels/forces.h): which swarms it moves, in which order, and
// on the native engine the moving itself. The OpenCL engine has its own way for that (opencl_forces.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/engine/far_field.hpp"
#include "controller/engine/neighbour_grid.hpp"
#include "controller/engine/thread_team.hpp"

namespace mayfly {

// A swarm that is moved by forces.
struct ForcedSwarm {
  std::size_t swarm = 0;  // among all
  NeighbourGrid grid;
  FarField far;
  std::vector<int> encounters;  // see MfEncounters
  kernels::MfMoment key{};      // of their draws
};

// Those of `swarms` that forces move, with room for all they need.
std::vector<ForcedSwarm> forced_swarms(std::span<const SwarmModel> swarms);

// Sorts the swarm for its search, and makes its mesh of attraction. Absent agents, who are not among the
// sorted, get zero velocity.
void sort_for_forces(ForcedSwarm& forced, const SwarmModel& model, const AgentColumns& at,
                     const VelocityColumns& out, ThreadTeam& team) noexcept;

// What kernels are told of walls and time; `field` and `moment` must outlive it.
kernels::MfSetting setting_of(const SwarmModel& model, const kernels::MfMoment& moment,
                              float period_s) noexcept;

class ForceStage {
 public:
  void prepare(std::span<const SwarmModel> swarms) { forced_ = forced_swarms(swarms); }
  bool on() const { return !forced_.empty(); }
  // The preferred velocity of every agent of a swarm that forces move; no other is touched.
  void compute(std::span<const SwarmModel> swarms, const AgentColumns& at, const TickTime& tick,
               const VelocityColumns& out, ThreadTeam& team) noexcept;

 private:
  std::vector<ForcedSwarm> forced_;
};

}  // namespace mayfly
