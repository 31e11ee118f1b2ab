#include "controller/engine/minimum_distance.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/field.h"

namespace mayfly {
namespace {

using kernels::F;
using kernels::F3;

// Eight agents of one swarm: no wall may be crossed to make room for a neighbour.
void guard_lanes(const SwarmModel& swarm, const PositionColumns& at, const VelocityColumns& velocity,
                 std::size_t local, std::span<const std::uint8_t> moved) noexcept {
  const std::size_t a = swarm.first + local;
  const std::size_t lanes = std::min<std::size_t>(MF_LANES, swarm.count - local);
  const bool any =
      std::any_of(moved.begin() + static_cast<std::ptrdiff_t>(a),
                  moved.begin() + static_cast<std::ptrdiff_t>(a + lanes), [](auto m) { return m != 0; });
  if (!any) {
    return;
  }
  float column[6][MF_LANES] = {};
  for (std::size_t k = 0; k < lanes; ++k) {
    column[0][k] = at.x[a + k];
    column[1][k] = at.y[a + k];
    column[2][k] = at.z[a + k];
    column[3][k] = velocity.x[a + k];
    column[4][k] = velocity.y[a + k];
    column[5][k] = velocity.z[a + k];
  }
  const F3 r =
      kernels::mf3(kernels::mf_load(column[0]), kernels::mf_load(column[1]), kernels::mf_load(column[2]));
  const F3 v =
      kernels::mf3(kernels::mf_load(column[3]), kernels::mf_load(column[4]), kernels::mf_load(column[5]));
  const F3 safe = kernels::mf_field_guard(r, v, &swarm.field, swarm.walls.data());
  for (std::size_t k = 0; k < lanes; ++k) {
    if (moved[a + k] != 0) {
      velocity.x[a + k] = safe.x[k];
      velocity.y[a + k] = safe.y[k];
      velocity.z[a + k] = safe.z[k];
    }
  }
}

}  // namespace

void MinimumDistance::prepare(std::span<const SwarmModel> swarms, std::size_t agents) {
  swarms_ = swarms;
  sweeps_ = 0;
  order_.reserve(agents);
  half_distance_.assign(agents, 0.0F);
  float largest = 0.0F;
  for (const SwarmModel& swarm : swarms) {
    std::fill_n(half_distance_.begin() + static_cast<std::ptrdiff_t>(swarm.first), swarm.count,
                0.5F * swarm.separation);
    sweeps_ = std::max(sweeps_, swarm.mde_sweeps);
    largest = std::max(largest, swarm.separation);
  }
  least_cell_ = largest;
  for (std::vector<float>* column : {&x_, &y_, &z_, &dx_, &dy_, &dz_}) {
    column->assign(agents, 0.0F);
  }
  moved_.assign(agents, 0);
}

std::size_t MinimumDistance::enforce(const PositionColumns& at, float period_s,
                                     const VelocityColumns& velocity, DisplacementSweep& sweep) noexcept {
  if (sweeps_ == 0 || least_cell_ <= 0.0F) {
    return 0;
  }
  for (std::size_t a = 0; a < x_.size(); ++a) {
    x_[a] = at.x[a] + velocity.x[a] * period_s;
    y_[a] = at.y[a] + velocity.y[a] * period_s;
    z_[a] = at.z[a] + velocity.z[a] * period_s;
    moved_[a] = 0;
  }
  bool any = false;
  for (int pass = 0; pass < sweeps_ && sweep_once(sweep); ++pass) {
    any = true;
  }
  if (!any) {
    return 0;
  }
  correct(at, period_s, velocity);
  return static_cast<std::size_t>(std::count(moved_.begin(), moved_.end(), std::uint8_t{1}));
}

bool MinimumDistance::sweep_once(DisplacementSweep& sweep) noexcept {
  order_.sort({x_, y_, z_}, half_distance_, least_cell_);
  sweep.displacements(order_, dx_, dy_, dz_);
  bool any = false;
  for (std::size_t sorted = 0; sorted < dx_.size(); ++sorted) {
    if (dx_[sorted] != 0.0F || dy_[sorted] != 0.0F || dz_[sorted] != 0.0F) {
      const auto a = static_cast<std::size_t>(order_.id()[sorted]);
      x_[a] += dx_[sorted];
      y_[a] += dy_[sorted];
      z_[a] += dz_[sorted];
      moved_[a] = 1;
      any = true;
    }
  }
  return any;
}

void MinimumDistance::correct(const PositionColumns& at, float period_s,
                              const VelocityColumns& velocity) noexcept {
  for (std::size_t a = 0; a < moved_.size(); ++a) {
    if (moved_[a] != 0) {
      velocity.x[a] = (x_[a] - at.x[a]) / period_s;
      velocity.y[a] = (y_[a] - at.y[a]) / period_s;
      velocity.z[a] = (z_[a] - at.z[a]) / period_s;
    }
  }
  for (const SwarmModel& swarm : swarms_) {
    for (std::size_t local = 0; local < swarm.count; local += MF_LANES) {
      guard_lanes(swarm, at, velocity, local, moved_);
    }
  }
}

}  // namespace mayfly
