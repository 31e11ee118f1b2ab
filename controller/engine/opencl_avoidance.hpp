// The OpenCL engine's own way to run kernels/orca.h. Neighbours are found on the host, as agents are sorted
// there: what a search writes down has no fast form in OpenCL C 1.2.
#pragma once

#include <cstddef>
#include <optional>

#include "compute/buffer.hpp"
#include "compute/program.hpp"
#include "controller/engine/avoidance.hpp"

namespace mayfly {

class OpenclAvoidance {
 public:
  static Result<OpenclAvoidance> create(const compute::Device& device);

  // Room for `agents`.
  Result<void> prepare(const compute::Device& device, std::size_t agents);

  // What was seen, and what agents prefer (m/s, in their order), to the device.
  compute::Status upload(const Avoidance& seen, const VelocityColumns& velocity) noexcept;
  // Starts one swarm, whose distance spline is `walls`.
  compute::Status start(const Avoidance& seen, std::size_t swarm, const SwarmModel& model,
                        const compute::Buffer<float>& walls, float period_s) noexcept;
  // Waits for all, and brings back what agents are told. Adds to `infeasible` how many nothing keeps clear.
  compute::Status download(const Avoidance& seen, const VelocityColumns& velocity,
                           std::size_t& infeasible) noexcept;

 private:
  explicit OpenclAvoidance(compute::Kernel kernel);

  struct Room {
    compute::Buffer<float> body, motion, vx, vy, vz, infeasible;
    compute::Buffer<int> id, nearest, slots;
  };
  compute::Kernel kernel_;
  std::optional<Room> room_;
};

}  // namespace mayfly
