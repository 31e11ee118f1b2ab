// Swarms that integrate forces, one for each model, noise and size that may make a difference.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/unit/engine/force_world.hpp"

namespace mayfly::test {

struct ForcedCase {
  const char* name;
  Motor motor;
  std::size_t agents;
  float far_error = 0.0F;
  int noise = -1;  // none
};

inline SwarmModel model_of(const ForcedCase& c) {
  SwarmModel model = forced_swarm(c.agents, c.motor);
  give_zones(model, {5.61, 5.0, 14.29, 0.17, 1.17, 3.0});
  model.far_error = c.far_error;
  model.forces.friction = 11.16F;
  model.forces.stimuli = 3;
  model.forces.stimulus[0] = {MF_STIMULUS_PREY, 2, 1, 0, 3, 4, 0, 0};
  model.forces.stimulus[1] = {MF_STIMULUS_PREDATOR, -1, 0, 1, 20, 2, 0, 0};
  model.forces.stimulus[2] = {MF_STIMULUS_AHEAD, 0, 0, 0, 2, 5, 1, 0.7F};
  model.boids = {1.0F, 0.8F, 0.6F, 0.5F, 1.0F, 1.2F, 2.0F};
  model.brownian = {20, 10, 0.01F, 1, 0.6F, 0.5F, 1, 2, 3};
  model.field.has_noise = c.noise >= 0 ? 1 : 0;
  model.field.noise.kind = c.noise;
  model.field.noise.octaves = 1;
  model.field.noise.seed = 77;
  model.field.noise.inverse_scale[0] = 1 / 0.8F;
  model.field.noise.gain[0] = 0.5F;
  model.field.noise.rms_speed = 1.0F;
  model.field.most_speed = 3.0F;
  return model;
}

// Eight ticks that agents fly on by what they are told; the predator follows, so that some are met again.
inline std::vector<Columns> flown(Engine& engine, const ForcedCase& c) {
  constexpr float kPeriod = 0.05F;
  Flyers flyers = flyers_in_box(c.agents, 6, 6, 3);
  const std::vector<SwarmModel> swarms{model_of(c)};
  EXPECT_TRUE(engine.prepare(swarms, c.agents));
  std::vector<Columns> all;
  for (std::uint64_t tick = 0; tick < 8; ++tick) {
    const float back_and_forth = tick % 4 < 2 ? 0.0F : 30.0F;
    const std::vector<glm::vec3> places{{2, 1, 0}, {back_and_forth, 0, 1}, {0, 0, 0}};
    engine.move_stimuli(0, places);
    if (tick == 3 && c.agents > 5) {
      flyers.at.y[5] = std::numeric_limits<float>::quiet_NaN();
    }
    Columns out(c.agents);
    engine.compute(flyers.columns(), {tick, kPeriod * static_cast<double>(tick), kPeriod}, out.velocities());
    EXPECT_EQ(engine.fault(), "");
    flyers.v = out;
    for (std::size_t a = 0; a < c.agents; ++a) {
      flyers.at.x[a] += kPeriod * out.x[a];
      flyers.at.y[a] += kPeriod * out.y[a];
      flyers.at.z[a] += kPeriod * out.z[a];
    }
    all.push_back(std::move(out));
  }
  return all;
}

inline auto forced_cases() {
  return testing::Values(
      ForcedCase{"one", Motor::kForces, 1}, ForcedCase{"nine", Motor::kForces, 9},
      ForcedCase{"forces", Motor::kForces, 2000}, ForcedCase{"far", Motor::kForces, 6000, 0.05F},
      ForcedCase{"curl", Motor::kForces, 700, 0, MF_NOISE_CURL},
      ForcedCase{"perlin", Motor::kForces, 700, 0, MF_NOISE_PERLIN},
      ForcedCase{"white", Motor::kForces, 700, 0, MF_NOISE_WHITE},
      ForcedCase{"gaussian", Motor::kForces, 700, 0, MF_NOISE_GAUSSIAN},
      ForcedCase{"boids", Motor::kBoids, 3000}, ForcedCase{"brownian", Motor::kBrownian, 1000},
      ForcedCase{"restless_boids", Motor::kBoids, 500, 0, MF_NOISE_CURL});
}

inline std::string name_of(const testing::TestParamInfo<ForcedCase>& one) {
  return one.param.name;
}

}  // namespace mayfly::test
