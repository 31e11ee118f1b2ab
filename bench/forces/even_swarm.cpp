#include "bench/forces/even_swarm.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "bench/common/least_seconds.hpp"

namespace mayfly::bench {

EvenSwarm::EvenSwarm(std::size_t agents, float range, float company)
    : side(range * std::cbrt(static_cast<float>(agents) * 4.0F / 3.0F * std::numbers::pi_v<float> / company)),
      wish(glm::normalize(glm::vec3(1.0F, 0.3F, 0.2F))),
      walls(1, 0.0F),
      guide{wish.x, wish.y, wish.z, 5.0F},
      rest(agents, 0.0F) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> coordinate(0.0F, side);
  std::normal_distribution<float> component;
  for (std::size_t a = 0; a < agents; ++a) {
    x.push_back(coordinate(engine));
    y.push_back(coordinate(engine));
    z.push_back(coordinate(engine));
    const glm::vec3 v = glm::normalize(glm::vec3(component(engine), component(engine), component(engine)));
    vx.push_back(v.x);
    vy.push_back(v.y);
    vz.push_back(v.z);
  }
}

SwarmModel EvenSwarm::model(bool strict) const {
  constexpr float kFar = 1e4F;
  SwarmModel model;
  model.count = x.size();
  model.walls = walls;
  model.guide = guide;
  model.rest = {rest, rest, rest};
  model.avoidance = {1, kRadius, kHorizon, 1.0F, kRange, kNeighbours, kMostSpeed, strict ? 1 : 0};
  kernels::MfField& f = model.field;
  f.grid = {-kFar, -kFar, -kFar, 2 * kFar, 0.5F / kFar, 1, 1, 1, 0};
  f.cruise_speed = f.most_speed = 1.0F;
  f.slow_down = f.goal_margin = 1.0F;
  f.radius = kRadius;
  f.approach_rate = 5.0F;
  f.low_x = f.low_y = f.low_z = -kFar;
  f.high_x = f.high_y = f.high_z = kFar;
  return model;
}

Result<double> tick_seconds(Engine& engine, const EvenSwarm& swarm, int rounds, bool strict) {
  const std::vector<SwarmModel> models{swarm.model(strict)};
  if (auto prepared = engine.prepare(models, swarm.x.size()); !prepared) {
    return fail(std::move(prepared.error()));
  }
  std::vector<float> x(swarm.x.size());
  std::vector<float> y(swarm.x.size());
  std::vector<float> z(swarm.x.size());
  return least_seconds(rounds, [&](int) {
    engine.compute(swarm.columns(), {0, 0.0, EvenSwarm::kPeriod}, {x, y, z});
  });
}

}  // namespace mayfly::bench
