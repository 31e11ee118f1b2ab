// The native engine: the kernels inlined in C++ loops over the columns. No allocation, no lock and no system
// call in a tick.
#include <algorithm>

#include "controller/engine/engine.hpp"
#include "controller/engine/force_stage.hpp"
#include "controller/engine/minimum_distance.hpp"
#include "controller/engine/moment.hpp"
#include "controller/engine/native_avoidance.hpp"
#include "controller/engine/permutation.hpp"
#include "controller/engine/thread_team.hpp"

namespace mayfly {
namespace {

using kernels::F3;

// Agents a thread takes at the least: below it, waking a second thread costs more than it brings.
constexpr std::size_t kGrain = 512;

class NativeEngine final : public Engine, private FirstSweep {
 public:
  explicit NativeEngine(int threads) : team_(threads) {}

  std::string_view name() const noexcept override { return "native"; }

  Result<void> prepare(std::span<const SwarmModel> swarms, std::size_t agents) override {
    swarms_.assign(swarms.begin(), swarms.end());
    agents_ = agents;
    avoidance_.prepare(swarms_, agents, team_.size());
    minimum_distance_.prepare(swarms_, agents);
    forces_.prepare(swarms_);
    return {};
  }

  void replace_fields(std::size_t swarm, const SwarmFields& fields) noexcept override {
    replace(swarms_[swarm], fields);
  }

  void move_stimuli(std::size_t swarm, std::span<const glm::vec3> places) noexcept override {
    place_stimuli(swarms_[swarm], places);
  }

  TickCounts compute(const AgentColumns& at, const TickTime& tick,
                     const VelocityColumns& out) noexcept override {
    forces_.compute(swarms_, at, tick, out, team_);
    for (const SwarmModel& swarm : swarms_) {
      if (swarm.motor != Motor::kField) {
        continue;
      }
      const kernels::MfMoment moment = moment_of(swarm.field.noise, tick.number, tick.time_s);
      team_.for_ranges(swarm.count, kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t local = first; local < last; local += MF_LANES) {
          eight_agents(swarm, moment, at, tick.period_s, out, local);
        }
      });
    }
    const std::size_t infeasible = avoidance_.on() ? avoid(at, tick.period_s, out) : 0;
    if (avoidance_.on() || forces_.on()) {
      minimum_distance_.look_ahead({at.x, at.y, at.z}, tick.period_s, out, team_);
    }
    return {minimum_distance_.enforce({at.x, at.y, at.z}, tick.period_s, out, *this, team_), infeasible};
  }

 private:
  std::size_t avoid(const AgentColumns& at, float period_s, const VelocityColumns& out) noexcept {
    avoidance_.look_round(at, team_);
    return avoid_collisions(avoidance_, swarms_, period_s, out, team_);
  }

  void eight_agents(const SwarmModel& swarm, const kernels::MfMoment& moment, const AgentColumns& at,
                    float period_s, const VelocityColumns& out, std::size_t local) noexcept {
    const std::size_t slot = swarm.first + local;
    const auto lanes = static_cast<int>(std::min<std::size_t>(MF_LANES, swarm.count - local));
    const kernels::MfTables tables{swarm.walls.data(),  swarm.guide.data(),  swarm.rest.x.data(),
                                   swarm.rest.y.data(), swarm.rest.z.data(), kPermutation.data()};
    fetch_ahead(at, out, swarm, local);
    const kernels::I id = kernels::mf_swarm_agents(&minimum_distance_.order()[slot], lanes);
    const F3 r = kernels::mf3(kernels::mf_gather(at.x.data(), id), kernels::mf_gather(at.y.data(), id),
                              kernels::mf_gather(at.z.data(), id));
    const F3 led =
        kernels::mf_field_velocity(r, id, id - static_cast<int>(swarm.first), &swarm.field, &moment, &tables);
    const F3 v = kernels::mf_of_present(r, led);
    kernels::mf_scatter(out.x.data(), id, v.x, lanes);
    kernels::mf_scatter(out.y.data(), id, v.y, lanes);
    kernels::mf_scatter(out.z.data(), id, v.z, lanes);
    const F3 ahead = kernels::mf3_add(r, kernels::mf3_scale(v, kernels::mf_splat(period_s)));
    const VelocityColumns to = minimum_distance_.ahead();
    kernels::mf_store_first(&to.x[slot], ahead.x, lanes);
    kernels::mf_store_first(&to.y[slot], ahead.y, lanes);
    kernels::mf_store_first(&to.z[slot], ahead.z, lanes);
  }

  // Neighbours in space are strangers in memory: of a large swarm each column's eight numbers come from eight
  // lines, and are asked for while the eight agents before are thought about.
  void fetch_ahead(const AgentColumns& at, const VelocityColumns& out, const SwarmModel& swarm,
                   std::size_t local) const noexcept {
    constexpr std::size_t kAhead = 2 * MF_LANES;
    if (local + kAhead + MF_LANES > swarm.count) {
      return;
    }
    const int* next = &minimum_distance_.order()[swarm.first + local + kAhead];
    for (int k = 0; k < MF_LANES; ++k) {
      const auto agent = static_cast<std::size_t>(next[k]);
      __builtin_prefetch(&at.x[agent]);
      __builtin_prefetch(&at.y[agent]);
      __builtin_prefetch(&at.z[agent]);
      __builtin_prefetch(&out.x[agent], 1);
      __builtin_prefetch(&out.y[agent], 1);
      __builtin_prefetch(&out.z[agent], 1);
    }
  }

  void first_sweep(const CellOrder& order, SearchReach reach, Displacements& out) noexcept override {
    displace_all(order, agents_, reach, out, team_);
  }

  ThreadTeam team_;
  std::vector<SwarmModel> swarms_;
  std::size_t agents_ = 0;
  Avoidance avoidance_;
  MinimumDistance minimum_distance_;
  ForceStage forces_;
};

}  // namespace

std::unique_ptr<Engine> make_native_engine(int threads) {
  return std::make_unique<NativeEngine>(threads);
}

}  // namespace mayfly
