// The OpenCL engine's own way to run kernels/forces.h. Sorting, and the mesh of attraction, stay on the host.
#pragma once

#include <optional>
#include <vector>

#include "compute/buffer.hpp"
#include "compute/program.hpp"
#include "controller/engine/force_stage.hpp"

namespace mayfly {

class OpenclForces {
 public:
  static Result<OpenclForces> create(const compute::Device& device);

  // Room for all that forces move.
  Result<void> prepare(const compute::Device& device, std::span<const SwarmModel> swarms);
  // Which of all swarms they are.
  std::size_t forced() const { return forced_.size(); }
  std::size_t swarm_of(std::size_t which) const { return forced_[which].swarm; }

  // What a kernel reads besides the swarm itself.
  struct Tables {
    const compute::Buffer<float>& walls;
    const compute::Buffer<int>& permutation;
  };
  // The preferred velocity of every agent of one of them.
  compute::Status compute(std::size_t which, const SwarmModel& model, const AgentColumns& at,
                          const TickTime& tick, const Tables& tables, const VelocityColumns& out,
                          ThreadTeam& team) noexcept;

 private:
  struct Room {
    compute::Buffer<int> eights, start, id, encounters;
    compute::Buffer<float> sorted, nodes;
    compute::Buffer<kernels::MfField> field;
    compute::Buffer<kernels::MfForces> model;
    compute::Buffer<float> vx, vy, vz;  // in the order of the flight
    std::size_t stride = 0;             // from one sorted column to the next
  };

  OpenclForces(compute::Kernel forces, compute::Kernel boids, compute::Kernel brownian);
  static Result<Room> make_room(const compute::Device& device, const ForcedSwarm& forced,
                                const SwarmModel& model);
  static compute::Status upload(Room& room, const ForcedSwarm& forced, const SwarmModel& model) noexcept;
  compute::Status start(Room& room, const ForcedSwarm& forced, const SwarmModel& model, const TickTime& tick,
                        const Tables& tables) noexcept;
  static compute::Status download(Room& room, const ForcedSwarm& forced, const VelocityColumns& out) noexcept;

  compute::Kernel forces_, boids_, brownian_;
  std::vector<ForcedSwarm> forced_;
  std::vector<Room> rooms_;  // one each
};

}  // namespace mayfly
