// BSwarm15's forces: ticks a second beside the paper as printed, and how far approximated forces are off.
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "bench/common/least_seconds.hpp"
#include "bench/common/ticks.hpp"
#include "bench/forces/bswarm15_scalar.hpp"
#include "bench/forces/crowd.hpp"
#include "bench/forces/measure.hpp"

namespace mayfly::bench {
namespace {

// The baseline takes minutes for 200 000 agents: so many of them, evenly spread, stand for all.
constexpr std::size_t kSample = 400;

struct Scalar {
  double seconds = 0.0;             // a tick of all agents
  std::vector<std::size_t> agents;  // of the sample
  std::vector<glm::vec3> forces;    // theirs, m/s²
};

BSwarm15Parameters parameters_of(const kernels::MfForces& f) {
  const kernels::MfStimulus& food = f.stimulus[0];
  return {.friction = f.friction,
          .rep_weight = f.rep_weight,
          .ali_weight = f.ali_weight,
          .att_weight = f.att_weight,
          .rep_radius = f.rep_radius,
          .ali_radius = f.ali_radius,
          .att_radius = f.att_radius,
          .food = {food.x, food.y, food.z},
          .food_weight = f.stimuli > 0 ? food.weight : 0.0F,
          .food_reach = f.stimuli > 0 ? food.reach : 0.0F};
}

Scalar run_scalar(const Crowd& crowd) {
  Scalar scalar;
  const std::size_t step = std::max<std::size_t>(1, crowd.places.size() / kSample);
  for (std::size_t agent = 0; agent < crowd.places.size(); agent += step) {
    scalar.agents.push_back(agent);
  }
  const BSwarm15Parameters parameters = parameters_of(crowd.swarms.front().forces);
  const double seconds = least_seconds(3, [&](int) {
    scalar.forces.clear();
    for (const std::size_t agent : scalar.agents) {
      scalar.forces.push_back(bswarm15_force(crowd.places, crowd.velocities, agent, parameters));
    }
  });
  scalar.seconds =
      seconds * static_cast<double>(crowd.places.size()) / static_cast<double>(scalar.agents.size());
  return scalar;
}

// The mean over the sample of |F − F_exact| / |F_exact|, of forces as the engine's first tick has them.
double mean_error(const Crowd& crowd, const Scalar& scalar, const std::vector<glm::vec3>& velocities) {
  const float period_s = crowd.flock().period_s;
  double sum = 0.0;
  for (std::size_t n = 0; n < scalar.agents.size(); ++n) {
    const std::size_t agent = scalar.agents[n];
    const glm::vec3 force = (velocities[agent] - crowd.velocities[agent]) / period_s;
    sum += static_cast<double>(glm::length(force - scalar.forces[n]) / glm::length(scalar.forces[n]));
  }
  return sum / static_cast<double>(scalar.agents.size());
}

struct Wanted {
  std::string key, what;
  double ticks_per_second = 0.0;
  double error = 0.0;
};

Result<void> add_rows(const ForcesPlan& plan, const Crowd& crowd, const Wanted& wanted, Report& report) {
  const auto engine = make_native_engine(plan.threads);
  const Scalar scalar = run_scalar(crowd);
  const auto velocities = first_velocities(*engine, crowd.flock());
  if (!velocities) {
    return fail(velocities.error());
  }
  const auto ticks = time_ticks(*engine, crowd.flock(), plan.ticks);
  if (!ticks) {
    return fail(ticks.error());
  }
  const std::string agents = std::to_string(crowd.places.size());
  report.rows.push_back({.key = wanted.key,
                         .what = agents + ' ' + wanted.what,
                         .value = 1.0 / ticks->seconds,
                         .unit = "ticks/s",
                         .wanted = wanted.ticks_per_second,
                         .less_is_better = false,
                         .baseline = "all pairs, scalar",
                         .baseline_value = 1.0 / scalar.seconds});
  report.rows.push_back({.key = wanted.key + "_error",
                         .what = "  of it, mean error of a force",
                         .value = mean_error(crowd, scalar, *velocities),
                         .unit = "",
                         .wanted = wanted.error});
  return {};
}

// Boids with about 29 others in range; beside them all pairs would take minutes.
Result<void> add_boids(const ForcesPlan& plan, Report& report) {
  const std::size_t agents = plan.at_most(100'000);
  const float side = std::cbrt(static_cast<float>(agents) / 6.92F);  // m: 29 in a ball of 1 m
  Crowd crowd = make_crowd(Motor::kBoids, strewn_in_box(agents, glm::vec3(side)), 2.0F);
  crowd.swarms.front().boids = {1.0F, 1.0F, 1.0F, 0.6F, 1.0F, 1.0F, 2.0F};
  const auto engine = make_native_engine(plan.threads);
  const auto ticks = time_ticks(*engine, crowd.flock(), plan.ticks);
  if (!ticks) {
    return fail(ticks.error());
  }
  report.rows.push_back({.key = "boids_100000",
                         .what = std::to_string(agents) + " Boids, 29 in range, an agent",
                         .value = 1e9 * ticks->seconds / static_cast<double>(agents),
                         .unit = "ns",
                         .wanted = 300.0});
  return {};
}

}  // namespace

Result<void> measure_force_rows(const ForcesPlan& plan, Report& report) {
  Crowd many = make_locusts(plan.at_most(200'000));
  many.swarms.front().far_error = 0.01F;
  return add_rows(plan, make_midges(plan.at_most(3000)), {"midges_3000", "midges, all in range", 200.0, 1e-4},
                  report)
      .and_then([&] {
        return add_rows(plan, make_locusts(plan.at_most(2000)), {"locusts_2000", "locusts", 1000.0, 1e-4},
                        report);
      })
      .and_then([&] {
        return add_rows(plan, many, {"locusts_200000", "locusts, far ones summed by cells", 3.0, 0.01},
                        report);
      })
      .and_then([&] { return add_boids(plan, report); });
}

}  // namespace mayfly::bench
