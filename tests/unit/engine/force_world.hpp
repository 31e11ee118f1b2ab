// Swarms for the force model: nothing but agents, in a world without walls or end.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "controller/engine/engine.hpp"
#include "tests/reference/forces_reference.hpp"
#include "tests/unit/engine/small_world.hpp"

namespace mayfly::test {

struct Flyers {
  Columns at, v;
  explicit Flyers(std::size_t n) : at(n), v(n) {}
  std::size_t size() const { return at.x.size(); }
  AgentColumns columns() const { return {at.x, at.y, at.z, v.x, v.y, v.z}; }
  reference::Agents exact() const {
    reference::Agents all;
    for (std::size_t a = 0; a < size(); ++a) {
      all.r.push_back({at.x[a], at.y[a], at.z[a]});
      all.v.push_back({v.x[a], v.y[a], v.z[a]});
    }
    return all;
  }
};

// Evenly in a box about the origin (m), velocities up to `speed` (m/s) an axis.
inline Flyers flyers_in_box(std::size_t n, float x, float y, float z, float speed = 1.0F, unsigned seed = 5) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> unit(-1, 1);
  Flyers all(n);
  for (std::size_t a = 0; a < n; ++a) {
    all.at.x[a] = 0.5F * x * unit(engine);
    all.at.y[a] = 0.5F * y * unit(engine);
    all.at.z[a] = 0.5F * z * unit(engine);
    all.v.x[a] = speed * unit(engine);
    all.v.y[a] = speed * unit(engine);
    all.v.z[a] = speed * unit(engine);
  }
  return all;
}

inline SwarmModel forced_swarm(std::size_t count, Motor motor = Motor::kForces) {
  SwarmModel model;
  model.count = count;
  model.motor = motor;
  kernels::MfField& f = model.field;
  f.most_speed = 1e6F;
  f.approach_rate = 1;
  f.low_x = f.low_y = f.low_z = -1e9F;
  f.high_x = f.high_y = f.high_z = 1e9F;
  return model;
}

inline void give_zones(SwarmModel& model, const reference::Zones& z) {
  kernels::MfForces& f = model.forces;
  f.rep_weight = static_cast<float>(z.rep_weight);
  f.ali_weight = static_cast<float>(z.ali_weight);
  f.att_weight = static_cast<float>(z.att_weight);
  f.rep_radius = static_cast<float>(z.rep);
  f.ali_radius = static_cast<float>(z.ali);
  f.att_radius = static_cast<float>(z.att);
}

// As float has them.
inline reference::Zones zones_of(const SwarmModel& model) {
  const kernels::MfForces& f = model.forces;
  return {f.rep_weight, f.ali_weight, f.att_weight, f.rep_radius, f.ali_radius, f.att_radius};
}

// One tick of a second: what comes out is v + F.
inline Columns flown_a_second(Engine& engine, const SwarmModel& model, const Flyers& flyers,
                              std::uint64_t tick = 0) {
  const std::vector<SwarmModel> swarms{model};
  EXPECT_TRUE(engine.prepare(swarms, flyers.size()));
  Columns out(flyers.size());
  engine.compute(flyers.columns(), {tick, static_cast<double>(tick), 1.0F}, out.velocities());
  EXPECT_EQ(engine.fault(), "");
  return out;
}

inline reference::Vec3 force_on(const Columns& out, const Flyers& flyers, std::size_t a) {
  return {double{out.x[a]} - flyers.v.x[a], double{out.y[a]} - flyers.v.y[a],
          double{out.z[a]} - flyers.v.z[a]};
}

}  // namespace mayfly::test
