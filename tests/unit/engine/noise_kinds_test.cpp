// Every kind of noise, drift, lamps and brushes: both engines give the same bits, and no wall is crossed.
#include <gtest/gtest.h>

#include "controller/engine/engine.hpp"
#include "tests/unit/engine/small_world.hpp"

namespace mayfly {
namespace {

using test::Columns;
using test::scattered;
using test::SmallWorld;

struct Case {
  const char* name;
  int kind;
  float drift;
  bool pulls;
};

constexpr std::size_t kAgents = 333;
constexpr TickTime kTick{1234, 12.34, 0.01F};

void give(SwarmModel& swarm, const Case& c) {
  swarm.field.noise.kind = c.kind;
  swarm.field.noise.rms_speed = 1.07F;
  swarm.field.noise.drift = c.drift;
  if (c.pulls) {
    swarm.field.pulls = 3;
    swarm.field.pull[0] = {MF_PULL_LAMP, 14, 12, 12, 6, 0.8F, 0.3F};
    swarm.field.pull[1] = {MF_PULL_BRUSH, 9, 12, 12, 5, 0.7F, 0};
    swarm.field.pull[2] = {MF_PULL_BRUSH, 12, 16, 12, 5, -0.7F, 0};
  }
}

Columns flown(Engine& engine, const SmallWorld& world, const Columns& at, const TickTime& tick) {
  EXPECT_TRUE(engine.prepare(world.swarms, at.x.size()));
  Columns out(at.x.size());
  engine.compute(at.positions(), tick, out.velocities());
  EXPECT_EQ(engine.fault(), "");
  return out;
}

class NoiseKinds : public testing::TestWithParam<Case> {
 protected:
  SmallWorld world() const {
    SmallWorld made(kAgents, 0.0F);
    for (SwarmModel& swarm : made.swarms) {
      give(swarm, GetParam());
    }
    return made;
  }
};

TEST_P(NoiseKinds, NativeAndOpenclGiveTheSameBits) {
  const SmallWorld made = world();
  const Columns at = scattered(kAgents, 10);
  auto opencl = make_opencl_engine();
  ASSERT_TRUE(opencl) << to_string(opencl.error());
  const Columns native = flown(*make_native_engine(1), made, at, kTick);
  EXPECT_EQ(native, flown(**opencl, made, at, kTick));
  EXPECT_EQ(native, flown(*make_native_engine(3), made, at, kTick));
}

TEST_P(NoiseKinds, ChangesFromTickToTickWhereItSaysSo) {
  const SmallWorld made = world();
  const Columns at = scattered(kAgents, 10);
  const Columns now = flown(*make_native_engine(1), made, at, kTick);
  const Columns later = flown(*make_native_engine(1), made, at, {1240, 12.40, 0.01F});
  const Case& c = GetParam();
  const bool stands_still =
      !c.pulls && c.drift == 0.0F && (c.kind == MF_NOISE_CURL || c.kind == MF_NOISE_PERLIN);
  EXPECT_EQ(now == later, stands_still);
}

TEST_P(NoiseKinds, EntersNoWall) {
  const SmallWorld made = world();
  const Columns at = scattered(kAgents, 7);
  const Columns v = flown(*make_native_engine(1), made, at, kTick);
  const kernels::MfField& field = made.swarms[0].field;
  for (std::size_t a = 0; a < kAgents; ++a) {
    const kernels::F3 r = kernels::mf3_splat(at.x[a], at.y[a], at.z[a]);
    const kernels::MfSurface s = kernels::mf_surface(r, made.walls.data(), &field.grid);
    const kernels::F3 n = kernels::mf3_unit(s.gradient);
    if (s.value[0] < 1.0F) {
      const float outward = v.x[a] * n.x[0] + v.y[a] * n.y[0] + v.z[a] * n.z[0];
      EXPECT_GE(outward, -(s.value[0] - field.radius) * field.approach_rate - 1e-4F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, NoiseKinds,
    testing::Values(Case{"curl", MF_NOISE_CURL, 0, false}, Case{"perlin", MF_NOISE_PERLIN, 0, false},
                    Case{"white", MF_NOISE_WHITE, 0, false}, Case{"gaussian", MF_NOISE_GAUSSIAN, 0, false},
                    Case{"drifting_curl", MF_NOISE_CURL, 0.5F, false},
                    Case{"drifting_perlin", MF_NOISE_PERLIN, 0.5F, false},
                    Case{"pulls", MF_NOISE_CURL, 0, true}, Case{"all_at_once", MF_NOISE_GAUSSIAN, 0, true}),
    [](const auto& one) { return one.param.name; });

}  // namespace
}  // namespace mayfly
