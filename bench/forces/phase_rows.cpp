// Phase transition (BSwarm15 §6, Ren16 Fig. 6): as a swarm gets denser its noise falls and its alignment
// rises, and past 50 agents a m³ it falls in step. The order is the length of the mean of the agents'
// directions.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <utility>
#include <vector>

#include "bench/common/ticks.hpp"
#include "bench/forces/crowd.hpp"
#include "bench/forces/measure.hpp"

namespace mayfly::bench {
namespace {

constexpr float kSide = 1.26F;      // m: 2 m³, so that 20 to 200 agents, the paper's, are 10 to 100 a m³
constexpr float kCritical = 50.0F;  // 1/m³
constexpr float kPeriod = 0.005F;   // s: at longer steps alignment overshoots by more than the swarm is fast
constexpr int kTicks = 2000;
constexpr int kCountedTicks = kTicks / 2;  // the last of them: the order has settled
constexpr int kSeeds = 3;
constexpr double kBelow = 45.0, kAbove = 55.0;  // 1/m³: between them the swarm switches

// The table's column. Its gain and its weight of alignment are what they have become at twice the critical
// density; the paper says how they go, not how far.
Crowd make_swarm(double density, std::uint32_t seed) {
  const auto agents =
      static_cast<std::size_t>(std::lround(density * std::pow(static_cast<double>(kSide), 3.0)));
  Crowd crowd = make_crowd(Motor::kForces, strewn_in_box(agents, glm::vec3(kSide), seed), 0.1F);
  SwarmModel& swarm = crowd.swarms.front();
  kernels::MfForces& forces = swarm.forces;
  const auto thick = static_cast<float>(density) / kCritical;
  forces.friction = 8.76F;
  forces.rep_weight = 5.0F;
  forces.rep_radius = 0.2F;
  forces.ali_weight = 10.0F * std::clamp(thick - 1.0F, 0.0F, 1.0F);
  forces.ali_radius = 2.4F;
  forces.att_weight = 7.0F;
  forces.att_radius = 11.6F;
  swarm.field.has_noise = 1;
  swarm.field.noise.octaves = 1;
  swarm.field.noise.seed = seed;
  swarm.field.noise.inverse_scale[0] = 1.0F / 0.72F;
  swarm.field.noise.gain[0] = 0.1F * std::max(1.0F, 2.0F / thick);
  return crowd;
}

double order_of(const std::vector<glm::vec3>& velocities) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3 v : velocities) {
    const float speed = glm::length(v);
    sum += speed > 0.0F ? glm::dvec3(v / speed) : glm::dvec3(0.0);
  }
  return glm::length(sum) / static_cast<double>(velocities.size());
}

// The mean of the flight's second half and of the seeds.
Result<double> order_at(const ForcesPlan& plan, double density) {
  double sum = 0.0;
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    const Crowd crowd = make_swarm(density, seed);
    Flock flock = crowd.flock();
    flock.period_s = kPeriod;
    const auto engine = make_native_engine(plan.threads);
    int ticks = 0;
    const auto flown = fly(*engine, flock, kTicks, [&](const std::vector<glm::vec3>& velocities) {
      sum += ++ticks > kTicks - kCountedTicks ? order_of(velocities) : 0.0;
    });
    if (!flown) {
      return fail(flown.error());
    }
  }
  return sum / static_cast<double>(kSeeds * kCountedTicks);
}

}  // namespace

Result<void> measure_phase_rows(const ForcesPlan& plan, Report& report) {
  Curve curve{"phase", "Phase transition", "agents a m³", "order", {}, false};
  auto& line = curve.lines.emplace_back("mean of three seeds", std::vector<glm::dvec2>{}).second;
  for (const double density :
       {10.0, 20.0, 30.0, 40.0, kBelow, 48.0, 50.0, 52.0, kAbove, 60.0, 70.0, 80.0, 100.0}) {
    const auto order = order_at(plan, density);
    if (!order) {
      return fail(order.error());
    }
    line.emplace_back(density, *order);
    if (density == kBelow || density == kAbove) {
      const bool above = density == kAbove;
      report.rows.push_back(
          {.key = above ? "phase_above" : "phase_below",
           .what = above ? "order at 55 agents a m³, past the switch" : "order at 45 agents a m³",
           .value = *order,
           .unit = "",
           .wanted = above ? 0.8 : 0.4,
           .less_is_better = !above});
    }
  }
  report.curves.push_back(std::move(curve));
  return {};
}

}  // namespace mayfly::bench
