// The native engine: the kernels inlined in C++ loops over the columns. No allocation, no lock and no system
// call in a tick.
#include <algorithm>

#include "controller/engine/engine.hpp"
#include "controller/engine/minimum_distance.hpp"
#include "controller/engine/moment.hpp"
#include "controller/engine/permutation.hpp"
#include "controller/engine/thread_team.hpp"

namespace mayfly {
namespace {

using kernels::F3;

// Agents a thread takes at the least: below it, waking a second thread costs more than it brings.
constexpr std::size_t kGrain = 512;

F3 load3(std::span<const float> x, std::span<const float> y, std::span<const float> z, std::size_t a,
         std::size_t lanes) {
  if (lanes == MF_LANES) {
    return kernels::mf3(kernels::mf_load(&x[a]), kernels::mf_load(&y[a]), kernels::mf_load(&z[a]));
  }
  float column[3][MF_LANES] = {};
  std::copy_n(&x[a], lanes, column[0]);
  std::copy_n(&y[a], lanes, column[1]);
  std::copy_n(&z[a], lanes, column[2]);
  return kernels::mf3(kernels::mf_load(column[0]), kernels::mf_load(column[1]), kernels::mf_load(column[2]));
}

class NativeEngine final : public Engine, private DisplacementSweep {
 public:
  explicit NativeEngine(int threads) : team_(threads) {}

  std::string_view name() const noexcept override { return "native"; }

  Result<void> prepare(std::span<const SwarmModel> swarms, std::size_t agents) override {
    swarms_.assign(swarms.begin(), swarms.end());
    minimum_distance_.prepare(swarms_, agents);
    return {};
  }

  void replace_fields(std::size_t swarm, const SwarmFields& fields) noexcept override {
    replace(swarms_[swarm], fields);
  }

  std::size_t compute(const PositionColumns& at, const TickTime& tick,
                      const VelocityColumns& out) noexcept override {
    for (const SwarmModel& swarm : swarms_) {
      const kernels::MfMoment moment = moment_of(swarm.field.noise, tick.number, tick.time_s);
      team_.for_ranges(swarm.count, kGrain, [&](std::size_t first, std::size_t last) {
        for (std::size_t local = first; local < last; local += MF_LANES) {
          eight_agents(swarm, moment, at, out, local);
        }
      });
    }
    return minimum_distance_.enforce(at, tick.period_s, out, *this);
  }

 private:
  static void eight_agents(const SwarmModel& swarm, const kernels::MfMoment& moment,
                           const PositionColumns& at, const VelocityColumns& out,
                           std::size_t local) noexcept {
    const std::size_t a = swarm.first + local;
    const std::size_t lanes = std::min<std::size_t>(MF_LANES, swarm.count - local);
    const F3 r = load3(at.x, at.y, at.z, a, lanes);
    const kernels::I id = kernels::mf_lane_index() + static_cast<int>(a);
    const F3 v = kernels::mf_field_velocity(r, load3(swarm.rest.x, swarm.rest.y, swarm.rest.z, local, lanes),
                                            id, &swarm.field, &moment, swarm.walls.data(), swarm.guide.data(),
                                            kPermutation.data());
    const int stored = static_cast<int>(lanes);
    kernels::mf_store_first(&out.x[a], v.x, stored);
    kernels::mf_store_first(&out.y[a], v.y, stored);
    kernels::mf_store_first(&out.z[a], v.z, stored);
  }

  void displacements(const CellOrder& order, std::span<float> dx, std::span<float> dy,
                     std::span<float> dz) noexcept override {
    team_.for_ranges(dx.size(), kGrain, [&](std::size_t first, std::size_t last) {
      for (std::size_t sorted = first; sorted < last; ++sorted) {
        const F3 d = kernels::mf_displacement(order.body(sorted), &order.cells(), order.start().data(),
                                              order.x().data(), order.y().data(), order.z().data(),
                                              order.half_distance().data(), order.id().data());
        dx[sorted] = kernels::mf_sum(d.x);
        dy[sorted] = kernels::mf_sum(d.y);
        dz[sorted] = kernels::mf_sum(d.z);
      }
    });
  }

  ThreadTeam team_;
  std::vector<SwarmModel> swarms_;
  MinimumDistance minimum_distance_;
};

}  // namespace

std::unique_ptr<Engine> make_native_engine(int threads) {
  return std::make_unique<NativeEngine>(threads);
}

}  // namespace mayfly
