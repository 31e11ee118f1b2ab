#include "controller/engine/native_avoidance.hpp"

#include <algorithm>
#include <atomic>

namespace mayfly {
namespace {

using kernels::I;

constexpr std::size_t kGrain = 64;

std::size_t eight_agents(const kernels::MfMinded& minded, const SwarmModel& swarm, const int* slots,
                         int lanes, float period_s, const VelocityColumns& velocity) noexcept {
  const I slot = kernels::mf_swarm_agents(slots, lanes);
  const I agent = kernels::mf_igather(minded.id, slot);
  const kernels::F3 wish =
      kernels::mf3(kernels::mf_gather(velocity.x.data(), agent), kernels::mf_gather(velocity.y.data(), agent),
                   kernels::mf_gather(velocity.z.data(), agent));
  const kernels::MfAvoided out =
      kernels::mf_avoid(slot, wish, &minded, &swarm.avoidance, &swarm.field, swarm.walls.data(), period_s);
  kernels::mf_scatter(velocity.x.data(), agent, out.v.x, lanes);
  kernels::mf_scatter(velocity.y.data(), agent, out.v.y, lanes);
  kernels::mf_scatter(velocity.z.data(), agent, out.v.z, lanes);
  int infeasible[MF_LANES];
  kernels::mf_unpack(out.infeasible, infeasible);
  return static_cast<std::size_t>(lanes - std::count(infeasible, infeasible + lanes, 0));
}

}  // namespace

std::size_t avoid_collisions(const Avoidance& seen, std::span<const SwarmModel> swarms, float period_s,
                             const VelocityColumns& velocity, ThreadTeam& team) noexcept {
  std::atomic<std::size_t> infeasible{0};
  const kernels::MfMinded minded = seen.minded();
  for (std::size_t s = 0; s < swarms.size(); ++s) {
    const std::span<const int> slots = seen.slots_of(s);
    team.for_ranges(slots.size(), kGrain, [&](std::size_t first, std::size_t last) {
      std::size_t here = 0;
      for (std::size_t n = first; n < last; n += MF_LANES) {
        const auto lanes = static_cast<int>(std::min<std::size_t>(MF_LANES, last - n));
        here += eight_agents(minded, swarms[s], &slots[n], lanes, period_s, velocity);
      }
      infeasible.fetch_add(here, std::memory_order_relaxed);
    });
  }
  return infeasible.load(std::memory_order_relaxed);
}

}  // namespace mayfly
