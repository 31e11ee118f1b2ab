#include "controller/engine/avoidance.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

constexpr std::size_t kChunk = 256;

}  // namespace

void Avoidance::prepare(std::span<const SwarmModel> swarms, std::size_t agents, std::size_t threads) {
  static_assert(kMostNearest == MF_MAX_NEIGHBOURS);
  swarms_ = swarms;
  range_ = 0.0F;
  most_ = 0;
  side_ = 0.0F;
  for (const SwarmModel& swarm : swarms) {
    if (swarm.avoidance.on != 0) {
      range_ = std::max(range_, swarm.avoidance.range);
      most_ = std::max(most_, swarm.avoidance.neighbours);
    }
  }
  slots_in_.assign(swarms.size(), 0);
  if (!on()) {
    return;
  }
  grid_.reserve(agents, threads);
  wide_.reserve(agents, threads);
  slot_of_.assign(agents, 0);
  wide_slot_of_.assign(agents, 0);
  const std::size_t padded = agents + MF_LANES;
  swarm_of_.assign(agents, 0);
  for (std::size_t s = 0; s < swarms.size(); ++s) {
    std::fill_n(swarm_of_.begin() + static_cast<std::ptrdiff_t>(swarms[s].first), swarms[s].count,
                static_cast<std::uint16_t>(s));
  }
  body_.assign(4 * padded, 0.0F);
  motion_.assign(4 * padded, 0.0F);
  nearest_.assign(kMostNearest * padded, -1);
  slots_.assign(padded, 0);
}

void Avoidance::look_round(const AgentColumns& at, ThreadTeam& team) noexcept {
  sort(at, team);
  take_bodies(at, team);
  take_slots();
  find_neighbours(at, team);
}

// Cells are as long as the longest range; in a crowd so short that a ball of that radius holds about twice as
// many as are looked for. Sorting says how crowded they were.
void Avoidance::sort(const AgentColumns& at, ThreadTeam& team) noexcept {
  constexpr int kRounds = 20;
  const float wanted = 0.6F * static_cast<float>(most_);  // agents a cell
  const bool first_tick = side_ <= 0.0F;
  side_ = first_tick ? range_ : side_;
  for (int round = 0; round < (first_tick ? kRounds : 1); ++round) {
    grid_.sort({at.x, at.y, at.z}, side_, team);
    const auto company = static_cast<float>(grid_.mean_company());
    if (company > 2.0F * wanted) {
      side_ = std::max(side_ * std::cbrt(std::max(wanted / company, 1e-3F)), 1e-6F * range_);
      continue;
    }
    side_ = company < 0.7F * wanted ? std::min(1.1F * side_, range_) : side_;
    break;
  }
}

void Avoidance::take_bodies(const AgentColumns& at, ThreadTeam& team) noexcept {
  const bool told = !at.vx.empty();
  team.for_ranges(grid_.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot) {
      const auto agent = static_cast<std::size_t>(grid_.id()[slot]);
      const SwarmModel& swarm = swarms_[swarm_of_[agent]];
      float* body = &body_[4 * slot];
      body[0] = grid_.x()[slot];
      body[1] = grid_.y()[slot];
      body[2] = grid_.z()[slot];
      body[3] = swarm.avoidance.on != 0 ? swarm.avoidance.radius : swarm.field.radius;
      float* motion = &motion_[4 * slot];
      const bool moves = told && std::isfinite(at.vx[agent] + at.vy[agent] + at.vz[agent]);
      motion[0] = moves ? at.vx[agent] : 0.0F;
      motion[1] = moves ? at.vy[agent] : 0.0F;
      motion[2] = moves ? at.vz[agent] : 0.0F;
      motion[3] = swarm.avoidance.on != 0 ? 1.0F : 0.0F;
    }
  });
}

void Avoidance::take_slots() noexcept {
  std::fill(slots_in_.begin(), slots_in_.end(), std::size_t{0});
  for (std::size_t slot = 0; slot < grid_.size(); ++slot) {
    const std::size_t s = swarm_of_[static_cast<std::size_t>(grid_.id()[slot])];
    if (swarms_[s].avoidance.on != 0) {
      slots_[first_slot(s) + slots_in_[s]++] = static_cast<int>(slot);
    }
  }
}

void Avoidance::find_neighbours(const AgentColumns& at, ThreadTeam& team) noexcept {
  constexpr float kPatience = 8.0F;  // sides of a cell
  const bool crowded = range_ > kPatience * grid_.side();
  if (crowded) {
    wide_.sort({at.x, at.y, at.z}, range_, team);
    for (std::size_t slot = 0; slot < grid_.size(); ++slot) {
      slot_of_[static_cast<std::size_t>(grid_.id()[slot])] = static_cast<int>(slot);
      wide_slot_of_[static_cast<std::size_t>(wide_.id()[slot])] = static_cast<int>(slot);
    }
  }
  const float patience = crowded ? kPatience * grid_.side() : range_;
  team.for_ranges(grid_.size(), kChunk, [&](std::size_t first, std::size_t last) {
    for (std::size_t slot = first; slot < last; ++slot) {
      const kernels::MfAvoidance& a =
          swarms_[swarm_of_[static_cast<std::size_t>(grid_.id()[slot])]].avoidance;
      const NearestQuery query{a.range, a.neighbours};
      if (a.on != 0 && !find_nearest(grid_, slot, query, patience, nearest_of(slot))) {
        find_far_ones(slot, query);
      }
    }
  });
}

// In the wide grid, whose numbers are then put into those of the other.
void Avoidance::find_far_ones(std::size_t slot, const NearestQuery& query) noexcept {
  const auto self = static_cast<std::size_t>(grid_.id()[slot]);
  const std::span<int, kMostNearest> found = nearest_of(slot);
  find_nearest(wide_, static_cast<std::size_t>(wide_slot_of_[self]), query, query.range, found);
  for (int& other : found) {
    other =
        other < 0 ? other : slot_of_[static_cast<std::size_t>(wide_.id()[static_cast<std::size_t>(other)])];
  }
}

}  // namespace mayfly
