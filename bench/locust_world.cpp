#include "bench/locust_world.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <tuple>
#include <utility>

#include "fields/cost_field.hpp"
#include "fields/distance_field.hpp"
#include "fields/geometry.hpp"
#include "fields/goal.hpp"
#include "fields/make_grid.hpp"
#include "fields/spline.hpp"

namespace mayfly::bench {
namespace {

constexpr Box kBounds{{0, 0, 0}, {120, 55, 50}};
constexpr Box kGoal{{105, 5, 5}, {118, 50, 40}};
constexpr float kRadius = 0.02F;

template <class T>
T or_die(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", to_string(result.error()).c_str());
    std::abort();
  }
  return std::move(*result);
}

// Four rows of houses, trees between them, two towers.
std::vector<fields::PlacedShape> village() {
  std::vector<fields::PlacedShape> shapes;
  for (int row = 0; row < 4; ++row) {
    for (int house = 0; house < 5; ++house) {
      const glm::vec3 corner(22.0F + 15.0F * static_cast<float>(house),
                             5.0F + 13.0F * static_cast<float>(row), 0);
      const float height = 5.0F + static_cast<float>((row + 2 * house) % 4);
      shapes.push_back({fields::BoxShape{{corner, corner + glm::vec3(7, 6, height)}}, {}});
      shapes.push_back({fields::SphereShape{corner + glm::vec3(10.5F, 3, 6), 2.5F}, {}});
    }
  }
  shapes.push_back({fields::CylinderShape{{40, 27, 0}, {40, 27, 30}, 3.0F}, {}});
  shapes.push_back({fields::CylinderShape{{80, 30, 0}, {80, 30, 35}, 3.0F}, {}});
  return shapes;
}

}  // namespace

LocustWorld::LocustWorld(int threads) : grid_(or_die(fields::make_grid(kBounds, 1.0F))) {
  const auto solid = or_die(fields::Geometry::make(village(), 1.0F));
  const auto distance = or_die(fields::build_distance_field(solid, grid_, threads, {}));
  const auto goal = or_die(fields::build_goal_distance({fields::BoxShape{kGoal}, {}}, grid_, threads, {}));
  fields::CostParams params;
  params.clearance = kRadius;
  guide_ = or_die(fields::build_cost_field(distance, goal, params, threads, {})).guide;
  walls_ = fields::spline_coefficients(grid_, distance.distance);
  distance_ = distance.distance;
}

AgentColumns LocustWorld::scatter(std::size_t agents) const {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  AgentColumns at;
  while (at.x.size() < agents) {
    const glm::vec3 p =
        kBounds.min + glm::vec3(unit(random), unit(random), unit(random)) * (kBounds.max - kBounds.min);
    const glm::ivec3 cell = glm::ivec3(p);
    if (p.x < kGoal.min.x - 10.0F && distance_[grid_.index(cell.x, cell.y, cell.z)] > 1.0F) {
      at.x.push_back(p.x);
      at.y.push_back(p.y);
      at.z.push_back(p.z);
    }
  }
  return at;
}

SwarmModel LocustWorld::swarm(std::size_t agents) {
  std::mt19937 random(2);
  for (auto [column, low, high] :
       {std::tuple{&rest_.x, kGoal.min.x, kGoal.max.x}, std::tuple{&rest_.y, kGoal.min.y, kGoal.max.y},
        std::tuple{&rest_.z, kGoal.min.z, kGoal.max.z}}) {
    std::uniform_real_distribution<float> along(low, high);
    column->resize(agents);
    std::generate(column->begin(), column->end(), [&, &a = along] { return a(random); });
  }
  SwarmModel model;
  model.count = agents;
  model.walls = walls_;
  model.guide = guide_;
  model.rest = {rest_.x, rest_.y, rest_.z};
  // In an even crowd n·(4π/3)d³ others are within d of an agent; most of them have been parted before.
  const double density = static_cast<double>(agents) / (95.0 * 55.0 * 50.0);
  model.separation = static_cast<float>(std::cbrt(0.009 / (4.19 * density)));
  model.mde_sweeps = 8;
  kernels::MfField& f = model.field;
  f.grid = {0, 0, 0, 1, 1, grid_.cells.x, grid_.cells.y, grid_.cells.z, 0};
  f.noise.octaves = 1;
  f.noise.seed = 3;
  f.noise.inverse_scale[0] = 1 / 0.6F;
  f.noise.gain[0] = 1.0F;
  f.has_noise = f.has_walls = 1;
  f.boundary = 1;
  f.wall_reach = 2;
  f.cruise_speed = 8;
  f.slow_down = 24;
  f.goal_margin = 0.5F;
  f.radius = kRadius;
  f.approach_rate = 5;
  f.low_x = kBounds.min.x + kRadius;
  f.low_y = kBounds.min.y + kRadius;
  f.low_z = kBounds.min.z + kRadius;
  f.high_x = kBounds.max.x - kRadius;
  f.high_y = kBounds.max.y - kRadius;
  f.high_z = kBounds.max.z - kRadius;
  return model;
}

TickCost time_ticks(Engine& engine, LocustWorld& world, std::size_t agents, int ticks, int runs) {
  const SwarmModel model = world.swarm(agents);
  AgentColumns at = world.scatter(agents);
  AgentColumns v{std::vector<float>(agents), std::vector<float>(agents), std::vector<float>(agents)};
  static_cast<void>(engine.prepare({&model, 1}, agents));
  TickTime tick;
  std::size_t moved = 0;
  const auto one_tick = [&] {
    moved += engine.compute({at.x, at.y, at.z}, tick, {v.x, v.y, v.z});
    for (auto [place, speed] : {std::pair{&at.x, &v.x}, std::pair{&at.y, &v.y}, std::pair{&at.z, &v.z}}) {
      for (std::size_t a = 0; a < agents; ++a) {
        (*place)[a] += (*speed)[a] * tick.period_s;
      }
    }
    ++tick.number;
  };
  for (int n = 0; n < ticks; ++n) {
    one_tick();
  }
  TickCost cost{1e9, 1e9, 0.0};
  moved = 0;
  for (int run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    for (int n = 0; n < ticks; ++n) {
      one_tick();
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    cost.seconds = std::min(cost.seconds, taken.count() / ticks);
    const auto cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    cost.cpu_seconds = std::min(cost.cpu_seconds, cpu / ticks);
  }
  cost.moved_share = static_cast<double>(moved) / (static_cast<double>(agents) * ticks * runs);
  return cost;
}

}  // namespace mayfly::bench
