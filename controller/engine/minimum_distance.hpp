// Minimum distance enforcement on the places where agents will be (Wang14 §6): the part that both engines
// share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "controller/engine/cell_order.hpp"
#include "controller/engine/engine.hpp"

namespace mayfly {

// One sweep over all agents; each engine has its own way to run it.
class DisplacementSweep {
 public:
  virtual ~DisplacementSweep() = default;
  // Displacement of each agent, in the order of `order`: kernels/mde.h, mf_displacement.
  virtual void displacements(const CellOrder& order, std::span<float> dx, std::span<float> dy,
                             std::span<float> dz) noexcept = 0;
};

class MinimumDistance {
 public:
  void prepare(std::span<const SwarmModel> swarms, std::size_t agents);

  // Corrects `velocity` so that agents at `at` keep their distance after `period_s`. Returns how many were
  // moved.
  std::size_t enforce(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
                      DisplacementSweep& sweep) noexcept;

 private:
  bool sweep_once(DisplacementSweep& sweep) noexcept;
  void correct(const PositionColumns& at, float period_s, const VelocityColumns& velocity) noexcept;

  std::span<const SwarmModel> swarms_;
  int sweeps_ = 0;
  float least_cell_ = 0.0F;  // m
  CellOrder order_;
  std::vector<float> half_distance_;  // m, one an agent
  std::vector<float> x_, y_, z_;      // where agents will be
  std::vector<float> dx_, dy_, dz_;   // displacements in sorted order
  std::vector<std::uint8_t> moved_;
};

}  // namespace mayfly
