// Agents in the open that each fly to a place of their own, for flights with collision avoidance.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "controller/engine/engine.hpp"

namespace mayfly::test {

struct Floats3 {
  std::vector<float> x, y, z;
  explicit Floats3(std::size_t n) : x(n), y(n), z(n) {}
  glm::vec3 at(std::size_t n) const { return {x[n], y[n], z[n]}; }
  void set(std::size_t n, glm::vec3 v) {
    x[n] = v.x;
    y[n] = v.y;
    z[n] = v.z;
  }
  bool operator==(const Floats3&) const = default;
};

// Deep in its goal an agent is led straight to its rest place (kernels/field.h).
struct OpenField {
  static constexpr float kPeriod = 0.05F;
  Floats3 at, velocity, home;
  std::vector<float> guide{0, 0, 0, -1000}, walls{1000};
  std::vector<SwarmModel> swarms;
  std::uint64_t tick = 0;
  std::size_t infeasible = 0;  // agents and ticks

  OpenField(const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& to)
      : at(from.size()), velocity(from.size()), home(from.size()) {
    for (std::size_t a = 0; a < from.size(); ++a) {
      at.set(a, from[a]);
      home.set(a, to[a]);
    }
    swarms.push_back(swarm(0, from.size()));
  }

  static kernels::MfAvoidance avoidance() { return {1, 0.25F, 2.0F, 0.5F, 5.0F, 10, 1.5F, 0}; }

  SwarmModel swarm(std::size_t first, std::size_t count) const {
    SwarmModel model;
    model.first = first;
    model.count = count;
    model.avoidance = avoidance();
    model.walls = walls;
    model.guide = guide;
    const auto own = [&](const std::vector<float>& column) {
      return std::span<const float>(column).subspan(first, count);
    };
    model.rest = {own(home.x), own(home.y), own(home.z)};
    kernels::MfField& f = model.field;
    f.grid = {-500, -500, -500, 1000, 1e-3F, 1, 1, 1, 0};
    f.cruise_speed = 1;
    f.most_speed = 1;
    f.slow_down = 0.5F;
    f.goal_margin = 1;
    f.radius = 0.25F;
    f.approach_rate = 5;
    f.low_x = f.low_y = f.low_z = -500;
    f.high_x = f.high_y = f.high_z = 500;
    return model;
  }

  void fly(Engine& engine, int ticks) {
    Floats3 out(at.x.size());
    for (int t = 0; t < ticks; ++t) {
      infeasible +=
          engine
              .compute({at.x, at.y, at.z, velocity.x, velocity.y, velocity.z},
                       {tick, static_cast<double>(tick) * double{kPeriod}, kPeriod}, {out.x, out.y, out.z})
              .infeasible;
      ++tick;
      for (std::size_t a = 0; a < at.x.size(); ++a) {
        at.set(a, at.at(a) + kPeriod * out.at(a));
      }
      velocity = out;
    }
  }

  float least_distance() const {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t a = 0; a < at.x.size(); ++a) {
      for (std::size_t b = a + 1; b < at.x.size(); ++b) {
        least = std::min(least, glm::distance(at.at(a), at.at(b)));
      }
    }
    return least;
  }
  float farthest_from_home() const {
    float farthest = 0.0F;
    for (std::size_t a = 0; a < at.x.size(); ++a) {
      farthest = std::max(farthest, glm::distance(at.at(a), home.at(a)));
    }
    return farthest;
  }
};

}  // namespace mayfly::test
