#include "controller/engine/minimum_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "kernels/field.h"

namespace mayfly {
namespace {

constexpr std::size_t kChunk = 512;

// Velocities that were changed, collected until they fill the lanes: no wall may be crossed to make room for
// a neighbour.
class Guard {
 public:
  Guard(const PositionColumns& at, const VelocityColumns& velocity) : at_(at), velocity_(velocity) {}

  void add(const SwarmModel& swarm, std::size_t agent) noexcept {
    if (swarm_ != &swarm || lanes_ == MF_LANES) {
      flush();
      swarm_ = &swarm;
    }
    agent_[lanes_++] = static_cast<int>(agent);
  }

  void flush() noexcept {
    if (lanes_ == 0) {
      return;
    }
    std::fill(agent_.begin() + lanes_, agent_.end(), agent_[0]);
    const kernels::I agents = kernels::mf_iload(agent_.data());
    const kernels::F3 r = gather(at_.x.data(), at_.y.data(), at_.z.data(), agents);
    const kernels::F3 v = gather(velocity_.x.data(), velocity_.y.data(), velocity_.z.data(), agents);
    const kernels::F3 safe = kernels::mf_field_guard(r, v, &swarm_->field, swarm_->walls.data());
    kernels::mf_scatter(velocity_.x.data(), agents, safe.x, lanes_);
    kernels::mf_scatter(velocity_.y.data(), agents, safe.y, lanes_);
    kernels::mf_scatter(velocity_.z.data(), agents, safe.z, lanes_);
    lanes_ = 0;
  }

 private:
  static kernels::F3 gather(const float* x, const float* y, const float* z, kernels::I agents) {
    return kernels::mf3(kernels::mf_gather(x, agents), kernels::mf_gather(y, agents),
                        kernels::mf_gather(z, agents));
  }

  const PositionColumns& at_;
  const VelocityColumns& velocity_;
  const SwarmModel* swarm_ = nullptr;
  std::array<int, MF_LANES> agent_{};
  int lanes_ = 0;
};

// Where the swarms may fly.
CellLimits limits_of(std::span<const SwarmModel> swarms) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  CellLimits limits{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const SwarmModel& swarm : swarms) {
    const kernels::MfField& f = swarm.field;
    const std::array<float, 3> low{f.low_x, f.low_y, f.low_z};
    const std::array<float, 3> high{f.high_x, f.high_y, f.high_z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      limits.low[axis] = std::min(limits.low[axis], low[axis]);
      limits.high[axis] = std::max(limits.high[axis], high[axis]);
    }
    limits.least_side = std::max(limits.least_side, swarm.separation);
  }
  return limits;
}

std::size_t swarm_of(std::span<const SwarmModel> swarms, std::size_t agent) {
  std::size_t s = 0;
  while (agent >= swarms[s].first + swarms[s].count) {
    ++s;
  }
  return s;
}

}  // namespace

void MinimumDistance::prepare(std::span<const SwarmModel> swarms, std::size_t agents) {
  swarms_ = swarms;
  agents_ = agents;
  sweeps_ = 0;
  limits_ = limits_of(swarms);
  const std::size_t padded = agents + MF_LANES;
  slots_.assign(padded, 0);
  std::iota(slots_.begin(), slots_.begin() + static_cast<std::ptrdiff_t>(agents), 0);
  half_distance_.assign(padded, 0.0F);
  float farthest_place = 0.0F;
  for (const SwarmModel& swarm : swarms) {
    std::fill_n(half_distance_.begin() + static_cast<std::ptrdiff_t>(swarm.first), swarm.count,
                0.5F * swarm.separation);
    sweeps_ = std::max(sweeps_, swarm.mde_sweeps);
  }
  for (std::size_t axis = 0; axis < 3 && !swarms.empty(); ++axis) {
    farthest_place = std::max({farthest_place, std::fabs(limits_.low[axis]), std::fabs(limits_.high[axis])});
  }
  rounding_ = 4.0F * std::numeric_limits<float>::epsilon() * farthest_place;
  reach_ = {0.5F * limits_.least_side, rounding_};
  order_.reserve(agents);
  for (std::vector<float>* column : {&ahead_x_, &ahead_y_, &ahead_z_}) {
    column->assign(padded, 0.0F);
  }
  displacements_.resize(agents);
  for (std::vector<std::uint8_t>* flags : {&moved_, &ever_moved_, &marks_}) {
    flags->assign(padded, 0);
  }
  farthest_move_.assign(agents / kChunk + 1, 0.0F);
}

void MinimumDistance::look_ahead(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
                                 ThreadTeam& team) noexcept {
  if (sweeps_ == 0 || limits_.least_side <= 0.0F) {
    return;
  }
  team.for_ranges(agents_, kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot) {
      const auto a = static_cast<std::size_t>(slots_[slot]);
      ahead_x_[slot] = at.x[a] + velocity.x[a] * period_s;
      ahead_y_[slot] = at.y[a] + velocity.y[a] * period_s;
      ahead_z_[slot] = at.z[a] + velocity.z[a] * period_s;
    }
  });
}

std::size_t MinimumDistance::enforce(const PositionColumns& at, float period_s,
                                     const VelocityColumns& velocity, FirstSweep& first,
                                     ThreadTeam& team) noexcept {
  if (sweeps_ == 0 || limits_.least_side <= 0.0F || agents_ == 0) {
    return 0;
  }
  order_.sort({ahead_x_, ahead_y_, ahead_z_, half_distance_, slots_, agents_}, limits_, team);
  take_order();
  std::fill(ever_moved_.begin(), ever_moved_.end(), std::uint8_t{0});
  reach_.slack = rounding_;
  first.first_sweep(order_, reach_, displacements_);
  for (int sweep = 1; apply(team) && sweep < sweeps_; ++sweep) {
    // Only where somebody moved can the next sweep differ from this one.
    mark_neighbours(order_, agents_, reach_, moved_, marks_, team);
    displace_marked(order_, agents_, reach_, marks_, displacements_, team);
  }
  correct(at, period_s, velocity, team);
  return static_cast<std::size_t>(std::count(ever_moved_.begin(), ever_moved_.end(), std::uint8_t{1}));
}

// The order of cells, swarm by swarm.
void MinimumDistance::take_order() noexcept {
  const std::span<const int> ids = order_.id().first(agents_);
  if (swarms_.size() == 1) {
    std::copy(ids.begin(), ids.end(), slots_.begin());
    return;
  }
  for (const SwarmModel& swarm : swarms_) {
    const auto is_own = [&](int id) { return static_cast<std::size_t>(id) - swarm.first < swarm.count; };
    std::copy_if(ids.begin(), ids.end(), slots_.begin() + static_cast<std::ptrdiff_t>(swarm.first), is_own);
  }
}

// Moves the agents that were pushed. False if nobody's place changed by it.
bool MinimumDistance::apply(ThreadTeam& team) noexcept {
  const std::size_t chunks = agents_ / kChunk + 1;
  std::fill_n(farthest_move_.begin(), chunks, 0.0F);
  team.for_ranges(agents_, kChunk, [&](std::size_t first, std::size_t last) {
    const Displacements& d = displacements_;
    float farthest = 0.0F;
    for (std::size_t a = first; a < last; ++a) {
      moved_[a] = 0;
      if (d.pushed[a] == 0 || (d.x[a] == 0.0F && d.y[a] == 0.0F && d.z[a] == 0.0F)) {
        continue;
      }
      ever_moved_[a] = 1;
      const std::array<float, 3> before{order_.x()[a], order_.y()[a], order_.z()[a]};
      const std::array<float, 3> after{before[0] + d.x[a], before[1] + d.y[a], before[2] + d.z[a]};
      moved_[a] = before != after ? 1 : 0;
      order_.x()[a] = after[0];
      order_.y()[a] = after[1];
      order_.z()[a] = after[2];
      farthest = std::max({farthest, std::fabs(d.x[a]), std::fabs(d.y[a]), std::fabs(d.z[a])});
    }
    farthest_move_[first / kChunk] = farthest;
  });
  const float farthest =
      *std::max_element(farthest_move_.begin(), farthest_move_.begin() + static_cast<std::ptrdiff_t>(chunks));
  reach_.slack += farthest + rounding_;
  return std::find(moved_.begin(), moved_.end(), std::uint8_t{1}) != moved_.end();
}

void MinimumDistance::correct(const PositionColumns& at, float period_s, const VelocityColumns& velocity,
                              ThreadTeam& team) noexcept {
  team.for_ranges(agents_, kChunk, [&](std::size_t first, std::size_t last) {
    Guard guard(at, velocity);
    for (std::size_t sorted = first; sorted < last; ++sorted) {
      if (ever_moved_[sorted] != 0) {
        const auto a = static_cast<std::size_t>(order_.id()[sorted]);
        velocity.x[a] = (order_.x()[sorted] - at.x[a]) / period_s;
        velocity.y[a] = (order_.y()[sorted] - at.y[a]) / period_s;
        velocity.z[a] = (order_.z()[sorted] - at.z[a]) / period_s;
        guard.add(swarms_[swarm_of(swarms_, a)], a);
      }
    }
    guard.flush();
  });
}

}  // namespace mayfly
