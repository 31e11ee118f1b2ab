// Attraction by a mesh against all pairs: as near as it is told to be, in swarms of several shapes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "controller/engine/far_field.hpp"
#include "tests/unit/engine/force_world.hpp"

namespace mayfly {
namespace {

using reference::length;
using reference::Zones;
using test::Columns;
using test::Flyers;
using test::flyers_in_box;

const Zones kLocusts{3, 5, 5, 0.45, 0.45, 5.45};
const Zones kAggregation{5.61, 5.0, 14.29, 0.17, 1.17, 6.29};
const Zones kAttraction{0, 0, 14.29, 0, 0, 5.29};

Flyers slab() {
  return flyers_in_box(12'000, 24, 5, 0.5F);
}
Flyers cube() {
  return flyers_in_box(16'000, 8, 8, 8);
}
// Dense in the middle, with two clouds that it hardly knows of.
Flyers clouds() {
  std::mt19937 engine(4);
  std::normal_distribution<float> normal(0, 0.8F);
  Flyers all(9000);
  for (std::size_t a = 0; a < all.size(); ++a) {
    all.at.x[a] = normal(engine) + 4.0F * static_cast<float>(a % 3);
    all.at.y[a] = normal(engine);
    all.at.z[a] = normal(engine) * 0.5F;
  }
  return all;
}

struct Case {
  const char* name;
  Flyers (*swarm)();
  Zones zones;
  float error;
};

class FarFields : public testing::TestWithParam<Case> {};

// Mean over a sample of |F − F_exact| / |F_exact|.
double mean_error(const Flyers& flyers, const SwarmModel& model) {
  constexpr std::size_t kEvery = 37;
  const Columns out = test::flown_a_second(*make_native_engine(2), model, flyers);
  const reference::Agents exact = flyers.exact();
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t a = 0; a < flyers.size(); a += kEvery, ++count) {
    const reference::Vec3 wanted = reference::interaction(exact, a, test::zones_of(model)).force;
    sum += length(test::force_on(out, flyers, a) - wanted) / length(wanted);
  }
  return sum / static_cast<double>(count);
}

TEST_P(FarFields, AreAsNearAsTheyAreToldToBe) {
  const Case& c = GetParam();
  Flyers flyers = c.swarm();
  SwarmModel model = test::forced_swarm(flyers.size());
  test::give_zones(model, c.zones);
  model.far_error = c.error;
  ThreadTeam alone(1);
  NeighbourGrid grid;
  FarField far;
  grid.reserve(0, flyers.size());
  far.reserve(flyers.size());
  grid.sort(flyers.columns(), 8, 0.1F, alone);
  far.build(grid, model, alone);
  ASSERT_EQ(far.mesh().on, 1);
  const double error = mean_error(flyers, model);
  RecordProperty("error", std::to_string(error));
  EXPECT_LE(error, c.error);
  EXPECT_GT(error, 1e-3 * static_cast<double>(c.error)) << "as good as exact: is the mesh used?";
}

INSTANTIATE_TEST_SUITE_P(Swarms, FarFields,
                         testing::Values(Case{"slab", slab, kLocusts, 0.02F},
                                         Case{"slab_coarse", slab, kLocusts, 0.05F},
                                         Case{"cube", cube, kAggregation, 0.05F},
                                         Case{"cube_of_attraction", cube, kAttraction, 0.05F},
                                         Case{"clouds", clouds, kLocusts, 0.05F},
                                         Case{"clouds_of_attraction", clouds, kAttraction, 0.05F}),
                         [](const auto& one) { return one.param.name; });

TEST(FarField, IsExactWhereItMustBe) {
  const Flyers flyers = flyers_in_box(3000, 24, 5, 0.5F);
  SwarmModel model = test::forced_swarm(flyers.size());
  test::give_zones(model, kLocusts);
  const Columns exact = test::flown_a_second(*make_native_engine(1), model, flyers);
  model.far_error = 1e-4F;  // would take more nodes than there are agents
  const Columns fine = test::flown_a_second(*make_native_engine(1), model, flyers);
  for (std::size_t a = 0; a < flyers.size(); ++a) {
    EXPECT_NEAR(exact.x[a], fine.x[a], 1e-4);
  }
}

// Strays that no cube holds are looked for pair by pair, and do not blow the mesh up.
TEST(FarField, BearsStrays) {
  Flyers flyers = slab();
  flyers.at.x[37] = 1e6F;
  flyers.at.y[74] = 9.0F;  // near enough to be drawn
  flyers.at.z[111] = -3e3F;
  SwarmModel model = test::forced_swarm(flyers.size());
  test::give_zones(model, kLocusts);
  model.far_error = 0.02F;
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  const reference::Agents exact = flyers.exact();
  for (const std::size_t a : {37U, 74U, 111U}) {
    const auto wanted = reference::interaction(exact, a, test::zones_of(model)).force;
    EXPECT_LE(length(test::force_on(out, flyers, a) - wanted), 1e-3) << a;
  }
}

TEST(FarField, OfACrowdAtOnePointIsNone) {
  Flyers flyers(5000);
  SwarmModel model = test::forced_swarm(5000);
  test::give_zones(model, kLocusts);
  model.far_error = 0.05F;
  EXPECT_EQ(test::flown_a_second(*make_native_engine(1), model, flyers), flyers.v);
}

}  // namespace
}  // namespace mayfly
