// A world made by hand for the engines: a ball in a box, a guide that leads along +x, agents at random.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "controller/engine/engine.hpp"
#include "fields/spline.hpp"

namespace mayfly::test {

struct Columns {
  std::vector<float> x, y, z;
  explicit Columns(std::size_t n) : x(n), y(n), z(n) {}
  AgentColumns positions() const { return {x, y, z}; }
  VelocityColumns velocities() { return {x, y, z}; }
  bool operator==(const Columns&) const = default;
};

struct SmallWorld {
  static constexpr int kCells = 24;  // of 1 m, from the origin
  std::vector<float> walls, guide;
  std::vector<float> rest_x, rest_y, rest_z;
  std::vector<SwarmModel> swarms;

  // `agents` in two swarms of unequal size, so that a swarm's end falls within eight lanes.
  explicit SmallWorld(std::size_t agents, float separation, bool noise = true)
      : rest_x(agents, 23.0F), rest_y(agents, 12.0F), rest_z(agents, 12.0F) {
    for (int k = 0; k < kCells; ++k) {
      for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
          const float dx = static_cast<float>(i) + 0.5F - 12;
          const float dy = static_cast<float>(j) + 0.5F - 12;
          const float dz = static_cast<float>(k) + 0.5F - 12;
          walls.push_back(std::sqrt(dx * dx + dy * dy + dz * dz) - 3.0F);
          guide.insert(guide.end(), {1.0F, 0.1F * dy / 12, 0.0F, 22.0F - static_cast<float>(i)});
        }
      }
    }
    walls = fields::spline_coefficients({{0, 0, 0}, 1, {kCells, kCells, kCells}}, walls);
    const std::size_t first = agents / 3;
    swarms.push_back(swarm(0, first, 7, separation, noise));
    swarms.push_back(swarm(first, agents - first, 8, separation, noise));
  }

  SwarmModel swarm(std::size_t first, std::size_t count, std::uint32_t seed, float separation,
                   bool noise) const {
    SwarmModel model;
    model.first = first;
    model.count = count;
    model.walls = walls;
    model.guide = guide;
    const auto own = [&](const std::vector<float>& column) {
      return std::span<const float>(column).subspan(first, count);
    };
    model.rest = {own(rest_x), own(rest_y), own(rest_z)};
    model.separation = separation;
    model.mde_sweeps = 20;
    kernels::MfField& f = model.field;
    f.grid = {0, 0, 0, 1, 1, kCells, kCells, kCells, 0};
    f.noise.octaves = 1;
    f.noise.seed = seed;
    f.noise.inverse_scale[0] = 1 / 0.4F;
    f.noise.gain[0] = 0.25F;
    f.has_noise = noise ? 1 : 0;
    f.has_walls = 1;
    f.boundary = 1;
    f.wall_reach = 2;
    f.cruise_speed = 1.5F;
    f.most_speed = 2.5F;  // some are led faster
    f.slow_down = 1.5F;
    f.goal_margin = 0.5F;
    f.radius = 0.05F;
    f.approach_rate = 5;
    f.low_x = f.low_y = f.low_z = -1000;
    f.high_x = f.high_y = f.high_z = 1000;
    return model;
  }
};

inline Columns scattered(std::size_t agents, float side, unsigned seed = 3) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> coordinate(12 - side / 2, 12 + side / 2);
  Columns at(agents);
  for (std::size_t a = 0; a < agents; ++a) {
    at.x[a] = coordinate(engine);
    at.y[a] = coordinate(engine);
    at.z[a] = coordinate(engine);
  }
  return at;
}

}  // namespace mayfly::test
