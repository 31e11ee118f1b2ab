#include "controller/engine/force_stage.hpp"

#include <algorithm>
#include <limits>

#include "controller/engine/moment.hpp"
#include "controller/engine/permutation.hpp"

namespace mayfly {
namespace {

using kernels::F3;
using kernels::I;

// No tick of a flight has this number: what is drawn by it holds for the whole flight.
constexpr std::uint64_t kNoTick = std::numeric_limits<std::uint64_t>::max();

// How far an agent looks for single neighbours, m.
float reach_of(const SwarmModel& model) {
  if (model.motor == Motor::kForces) {
    const kernels::MfForces& f = model.forces;
    // Where a mesh attracts, pairs are looked for in the inner zones alone.
    return f.att_weight != 0.0F && model.far_error <= 0.0F ? f.att_radius : f.ali_radius;
  }
  if (model.motor == Motor::kBoids) {
    const kernels::MfBoids& b = model.boids;
    return std::max({b.separation_radius, b.alignment_radius, b.cohesion_radius});
  }
  return 0.0F;
}

// A thread takes so many eights at a time that it is not for nothing that it wakes up.
std::size_t grain_of(const SwarmModel& model) {
  constexpr std::size_t kAlone = 64;  // of the models without neighbours
  return model.motor == Motor::kBrownian ? kAlone : std::clamp<std::size_t>(4096 / model.count, 1, 32);
}

F3 velocity_of(const kernels::MfEight& e, const SwarmModel& model, ForcedSwarm& forced,
               const kernels::MfCompany& company, const kernels::MfSetting& setting) {
  if (model.motor == Motor::kForces) {
    const kernels::MfEncounters met{&forced.key, forced.encounters.data(), static_cast<int>(model.first),
                                    static_cast<int>(model.count)};
    return kernels::mf_forces_velocity(&e, &model.forces, &company, &met, &setting);
  }
  if (model.motor == Motor::kBoids) {
    return kernels::mf_boids_velocity(&e, &model.boids, &company, &setting);
  }
  return kernels::mf_brownian_velocity(&e, &model.brownian, &setting);
}

}  // namespace

std::vector<ForcedSwarm> forced_swarms(std::span<const SwarmModel> swarms) {
  std::vector<ForcedSwarm> all;
  for (std::size_t s = 0; s < swarms.size(); ++s) {
    const SwarmModel& model = swarms[s];
    if (model.motor == Motor::kField || model.count == 0) {
      continue;
    }
    ForcedSwarm& forced = all.emplace_back();
    forced.swarm = s;
    forced.grid.reserve(model.first, model.count);
    forced.key = moment_of(model.field.noise, kNoTick, 0.0);
    if (model.motor == Motor::kForces) {
      forced.encounters.assign(model.count * static_cast<std::size_t>(model.forces.stimuli), 0);
      forced.far.reserve(model.count);
    }
  }
  return all;
}

void sort_for_forces(ForcedSwarm& forced, const SwarmModel& model, const AgentColumns& at,
                     const VelocityColumns& out, ThreadTeam& team) noexcept {
  constexpr float kCompany = 8.0F;   // agents a cell: fewer are more rows, more are farther apart
  constexpr float kFinest = 0.125F;  // of the reach: smaller cells are more rows, and no fewer agents
  forced.grid.sort(at, kCompany, kFinest * reach_of(model), team);
  if (model.motor == Motor::kForces) {
    forced.far.build(forced.grid, model, team);
  }
  for (const int agent : forced.grid.absent()) {
    const auto a = static_cast<std::size_t>(agent);
    out.x[a] = out.y[a] = out.z[a] = 0.0F;
  }
}

kernels::MfSetting setting_of(const SwarmModel& model, const kernels::MfMoment& moment,
                              float period_s) noexcept {
  return {&model.field,        &moment,  model.walls.data(),
          kPermutation.data(), period_s, model.avoidance.on != 0 ? 0 : 1};
}

void ForceStage::compute(std::span<const SwarmModel> swarms, const AgentColumns& at, const TickTime& tick,
                         const VelocityColumns& out, ThreadTeam& team) noexcept {
  for (ForcedSwarm& forced : forced_) {
    const SwarmModel& model = swarms[forced.swarm];
    sort_for_forces(forced, model, at, out, team);
    const kernels::MfMoment moment = moment_of(model.field.noise, tick.number, tick.time_s);
    const kernels::MfSetting setting = setting_of(model, moment, tick.period_s);
    const kernels::MfCompany company{forced.grid.cubes(), forced.grid.neighbours(), forced.far.mesh(),
                                     forced.far.nodes().data()};
    const std::span<const int> eights = forced.grid.eights();
    team.for_ranges(forced.grid.eight_count(), grain_of(model), [&](std::size_t first, std::size_t last) {
      for (std::size_t g = first; g < last; ++g) {
        const kernels::MfEight e = kernels::mf_sorted_eight(&company.neighbours, forced.grid.id().data(),
                                                            eights[g], eights[g + 1] - eights[g]);
        const F3 v = velocity_of(e, model, forced, company, setting);
        kernels::mf_scatter(out.x.data(), e.id, v.x, e.lanes);
        kernels::mf_scatter(out.y.data(), e.id, v.y, e.lanes);
        kernels::mf_scatter(out.z.data(), e.id, v.z, e.lanes);
      }
    });
  }
}

}  // namespace mayfly
