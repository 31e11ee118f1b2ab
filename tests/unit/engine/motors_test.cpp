// Boids and Brownian particles against double precision; noise as a force.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/motors_reference.hpp"
#include "tests/unit/engine/force_world.hpp"

namespace mayfly {
namespace {

using reference::length;
using reference::Vec3;
using test::Columns;
using test::Flyers;
using test::flyers_in_box;

Vec3 velocity(const Columns& out, std::size_t a) {
  return {out.x[a], out.y[a], out.z[a]};
}

TEST(Boids, TurnAsTheirNeighboursMakeThem) {
  constexpr std::size_t kAgents = 1500;
  const Flyers flyers = flyers_in_box(kAgents, 7, 7, 7);
  SwarmModel model = test::forced_swarm(kAgents, Motor::kBoids);
  model.boids = {2.0F, 0.8F, 0.6F, 0.7F, 1.1F, 1.6F, 3.0F};
  const reference::Boids boids{2.0, 0.8F, 0.6F, 0.7F, 1.1F, 1.6F};
  const Columns out = test::flown_a_second(*make_native_engine(2), model, flyers);
  const reference::Agents exact = flyers.exact();
  for (std::size_t a = 0; a < kAgents; ++a) {
    const Vec3 wanted = 3.0 * reference::unit(exact.v[a] + reference::flocking(exact, a, boids));
    ASSERT_LE(length(velocity(out, a) - wanted), 3e-4) << a;
  }
}

TEST(Boids, WithoutNeighboursFlyOn) {
  Flyers flyers = flyers_in_box(2, 1, 1, 1);
  flyers.at.x[1] = 100;
  SwarmModel model = test::forced_swarm(2, Motor::kBoids);
  model.boids = {2.0F, 0.8F, 0.6F, 0.7F, 1.1F, 1.6F, 3.0F};
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  EXPECT_LE(length(velocity(out, 0) - 3.0 * reference::unit(flyers.exact().v[0])), 1e-5);
}

TEST(BrownianParticles, DriftAsTheirDepotDrivesThem) {
  constexpr std::size_t kAgents = 100;
  const Flyers flyers = flyers_in_box(kAgents, 7, 7, 7);
  SwarmModel model = test::forced_swarm(kAgents, Motor::kBrownian);
  model.brownian = {2, 10, 0.5F, 1, 0, 0.5F, 1, 2, 3};
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  const reference::Agents exact = flyers.exact();
  for (std::size_t a = 0; a < kAgents; ++a) {
    const Vec3 wanted =
        exact.v[a] + reference::drift(exact.r[a], exact.v[a], {2, 10, 0.5, 1, 0.5, {1, 2, 3}});
    ASSERT_LE(length(velocity(out, a) - wanted), 1e-4 * length(wanted)) << a;
  }
}

// Free particles: what chance adds to the velocity in a tick has the variance 2D · period along each axis.
TEST(BrownianParticles, AreKickedWithTheVarianceOfTheirNoise) {
  constexpr std::size_t kAgents = 20'000;
  constexpr float kPeriod = 0.04F;
  const Flyers flyers(kAgents);
  SwarmModel model = test::forced_swarm(kAgents, Motor::kBrownian);
  model.brownian.noise = 0.6F;
  const std::vector<SwarmModel> swarms{model};
  const auto engine = make_native_engine(1);
  ASSERT_TRUE(engine->prepare(swarms, kAgents));
  Columns out(kAgents);
  engine->compute(flyers.columns(), {7, 0.28, kPeriod}, out.velocities());
  for (const auto* column : {&out.x, &out.y, &out.z}) {
    double sum = 0, squares = 0;
    for (const float v : *column) {
      sum += static_cast<double>(v);
      squares += static_cast<double>(v) * static_cast<double>(v);
    }
    EXPECT_NEAR(squares / kAgents, 0.36 * 0.04, 0.04 * 0.36 * 0.04);
    EXPECT_NEAR(sum / kAgents, 0, 4 * 0.12 / std::sqrt(static_cast<double>(kAgents)));
  }
}

// F_noise is what the field model has as a velocity.
TEST(Forces, HaveEachKindOfNoise) {
  constexpr std::size_t kAgents = 60;
  const Flyers flyers = flyers_in_box(kAgents, 7, 7, 7);
  for (const int kind : {MF_NOISE_CURL, MF_NOISE_PERLIN, MF_NOISE_WHITE, MF_NOISE_GAUSSIAN}) {
    SwarmModel model = test::forced_swarm(kAgents);
    test::give_zones(model, {5, 3, 2, 0.5, 1.5, 2.5});
    const Columns still = test::flown_a_second(*make_native_engine(1), model, flyers, 3);
    model.field.has_noise = 1;
    model.field.noise = {kind, 1, 0, 5, {1 / 0.8F}, {0.5F}, 1.3F, 0};
    const Columns moved = test::flown_a_second(*make_native_engine(1), model, flyers, 3);
    double squares = 0;
    for (std::size_t a = 0; a < kAgents; ++a) {
      const Vec3 noise = velocity(moved, a) - velocity(still, a);
      squares += length(noise) * length(noise);
      if (kind == MF_NOISE_CURL) {
        const kernels::F3 r = kernels::mf3_splat(flyers.at.x[a], flyers.at.y[a], flyers.at.z[a]);
        const kernels::F3 curl = kernels::mf_curl_noise(r, &model.field.noise, nullptr);
        ASSERT_LE(length(noise - Vec3{curl.x[0], curl.y[0], curl.z[0]}), 1e-5) << a;
      }
    }
    EXPECT_NEAR(std::sqrt(squares / kAgents),
                kind == MF_NOISE_WHITE || kind == MF_NOISE_GAUSSIAN ? 1.3 : 1.07, 0.35)
        << kind;
  }
}

}  // namespace
}  // namespace mayfly
