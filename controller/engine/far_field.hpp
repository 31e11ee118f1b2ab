// The mesh that a swarm's attraction is read from where it need not be exact (kernels/far.h). Made on the
// host for both engines: it is a small part of a tick.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "controller/engine/engine.hpp"
#include "controller/engine/neighbour_grid.hpp"
#include "controller/engine/thread_team.hpp"
#include "kernels/far.h"

namespace mayfly {

class FarField {
 public:
  // Room for a swarm of `agents`; nothing allocates afterwards.
  void reserve(std::size_t agents);

  // Makes the mesh for a swarm that is sorted. It is off where the model wants attraction exact, or where
  // going through all pairs is no more work.
  void build(const NeighbourGrid& grid, const SwarmModel& model, ThreadTeam& team) noexcept;

  const kernels::MfMesh& mesh() const { return mesh_; }
  // Four floats each: Σ far (x, y, z) and the number of neighbours.
  std::span<const float> nodes() const { return nodes_; }
  static std::size_t most_nodes(std::size_t agents) { return agents / 2 + 64; }

 private:
  struct Sum {
    double x = 0.0, y = 0.0, z = 0.0;
    int agents = 0;
  };

  bool choose_cubes(const NeighbourGrid& grid, const SwarmModel& model) noexcept;
  bool gather_lumps(const NeighbourGrid& grid) noexcept;
  bool is_read(int x, int y, int z) const noexcept;
  void fill_nodes(std::size_t first, std::size_t last) noexcept;

  kernels::MfMesh mesh_{};
  std::vector<float> nodes_;
  std::vector<Sum> sums_;   // one a cube
  std::vector<int> start_;  // of the lumps, one a cube
  std::vector<float> x_, y_, z_, mass_;
  std::vector<int> strays_;  // slots
  std::size_t stray_count_ = 0;
};

}  // namespace mayfly
