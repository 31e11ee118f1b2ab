// The force model against all pairs in double precision.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/engine/force_world.hpp"

namespace mayfly {
namespace {

using reference::length;
using reference::Vec3;
using reference::Zones;
using test::Columns;
using test::Flyers;
using test::flyers_in_box;

struct Case {
  const char* name;
  std::size_t agents;
  float x, y, z;  // m
  Zones zones;
};

const Zones kMidges{5.61, 0, 14.29, 0.17, 0.17, 5.29};
const Zones kAggregation{5.61, 5.0, 14.29, 0.17, 1.17, 6.29};
const Zones kLocusts{3, 5, 5, 0.45, 0.45, 5.45};

class Interactions : public testing::TestWithParam<Case> {};

// Of its own force every agent gets all but a ten-thousandth; where thousands cancel out, of a thousandth of
// the weights.
void expect_as_reference(const Flyers& flyers, const SwarmModel& model, const Columns& out) {
  const reference::Agents exact = flyers.exact();
  const Zones zones = test::zones_of(model);
  const double weights = zones.rep_weight + zones.ali_weight + zones.att_weight;
  for (std::size_t a = 0; a < flyers.size(); ++a) {
    const auto wanted = reference::interaction(exact, a, zones);
    const Vec3 own = reference::friction(exact.v[a], model.forces.friction);
    const Vec3 error = test::force_on(out, flyers, a) - wanted.force - own;
    const double size = std::max(length(wanted.force + own), 1e-3 * weights);
    ASSERT_LE(length(error), 1e-4 * size + wanted.uncertain) << a << " of " << flyers.size();
  }
}

TEST_P(Interactions, AreThoseOfAllPairs) {
  const Case& c = GetParam();
  const Flyers flyers = flyers_in_box(c.agents, c.x, c.y, c.z);
  SwarmModel model = test::forced_swarm(c.agents);
  test::give_zones(model, c.zones);
  model.forces.friction = 11.16F;
  expect_as_reference(flyers, model, test::flown_a_second(*make_native_engine(2), model, flyers));
}

INSTANTIATE_TEST_SUITE_P(
    Swarms, Interactions,
    testing::Values(Case{"nobody_near", 1, 1, 1, 1, kMidges}, Case{"two", 2, 1, 1, 1, kMidges},
                    Case{"nine", 9, 3, 3, 3, kAggregation}, Case{"midges", 3000, 4, 4, 4, kMidges},
                    Case{"aggregation", 3000, 9, 9, 9, kAggregation},
                    Case{"spread_aggregation", 2000, 40, 40, 40, kAggregation},
                    Case{"locusts", 2000, 24, 5, 0.5F, kLocusts},
                    Case{"on_a_line", 500, 0, 0, 60, kAggregation},
                    Case{"no_attraction", 2000, 9, 9, 9, {5, 5, 0, 0.5, 1.5, 1.5}},
                    Case{"alignment_without_weight", 2000, 9, 9, 9, {5, 0, 3, 0.5, 1.5, 2.5}},
                    Case{"attraction_alone", 1000, 9, 9, 9, {0, 0, 3, 0, 0, 2.5}}),
    [](const auto& one) { return one.param.name; });

TEST(ForceZones, OfZonesAreExactAtTheirEdges) {
  // Along +x from the first, alone with it: r_rep, r_ali and r_att belong to the next zone, the next, and
  // still to attraction.
  struct Edge {
    float x;
    Vec3 force;
  };
  SwarmModel model = test::forced_swarm(2);
  test::give_zones(model, {3, 5, 7, 0.45, 1.3, 5.45});
  const kernels::MfForces& f = model.forces;
  const float beyond = std::nextafter(f.att_radius, 100.0F);
  for (const Edge& edge :
       {Edge{std::nextafter(f.rep_radius, 0.0F), {-3, 0, 0}}, Edge{f.rep_radius, {0, 5, 0}},
        Edge{std::nextafter(f.ali_radius, 0.0F), {0, 5, 0}}, Edge{f.ali_radius, {7, 0, 0}},
        Edge{f.att_radius, {7, 0, 0}}, Edge{beyond, {0, 0, 0}}}) {
    Flyers flyers(2);
    flyers.at.x[1] = edge.x;
    flyers.v.y[1] = 2.0F;
    const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
    EXPECT_LE(length(test::force_on(out, flyers, 0) - edge.force), 1e-5) << edge.x;
  }
}

TEST(ForceZones, OfAgentsAtOnePointAreNone) {
  constexpr std::size_t kAgents = 40;
  for (const Zones& zones : {kMidges, Zones{0, 0, 5, 0, 0, 2}, Zones{0, 4, 0, 0, 2, 2}}) {
    Flyers flyers(kAgents);
    SwarmModel model = test::forced_swarm(kAgents);
    test::give_zones(model, zones);
    for (std::size_t a = 0; a < kAgents; ++a) {
      flyers.at.x[a] = flyers.at.y[a] = 3.0F;
      flyers.v.x[a] = 1.0F;  // all alike: no relative velocity either
    }
    EXPECT_EQ(test::flown_a_second(*make_native_engine(1), model, flyers), flyers.v);
  }
}

// Those at one point count as neighbours all the same: they take part in the mean.
TEST(ForceZones, CountCoincidentNeighbours) {
  Flyers flyers(3);
  flyers.at.x[2] = 0.1F;
  SwarmModel model = test::forced_swarm(3);
  test::give_zones(model, kMidges);
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  EXPECT_NEAR(out.x[0], -5.61 / 2, 1e-5);
  EXPECT_NEAR(out.x[2], 5.61, 1e-5);
}

TEST(ForceZones, KnowNoAbsentAgents) {
  constexpr std::size_t kAgents = 300;
  Flyers flyers = flyers_in_box(kAgents, 5, 5, 5);
  Flyers present(0);
  for (std::size_t a = 0; a < kAgents; ++a) {
    if (a % 3 == 1) {
      (a % 2 == 0 ? flyers.at.x : flyers.at.z)[a] = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    for (auto columns : {&Flyers::at, &Flyers::v}) {
      (present.*columns).x.push_back((flyers.*columns).x[a]);
      (present.*columns).y.push_back((flyers.*columns).y[a]);
      (present.*columns).z.push_back((flyers.*columns).z[a]);
    }
  }
  SwarmModel model = test::forced_swarm(kAgents);
  test::give_zones(model, kAggregation);
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  model.count = present.size();
  const Columns alone = test::flown_a_second(*make_native_engine(1), model, present);
  std::size_t next = 0;
  for (std::size_t a = 0; a < kAgents; ++a) {
    const std::array<float, 3> own{out.x[a], out.y[a], out.z[a]};
    if (a % 3 == 1) {
      EXPECT_EQ(own, (std::array<float, 3>{})) << a;
    } else {
      EXPECT_NEAR(own[0], alone.x[next], 1e-4) << a;
      EXPECT_NEAR(own[2], alone.z[next++], 1e-4) << a;
    }
  }
}

TEST(ForceZones, HoldWithStraysFarAway) {
  constexpr std::size_t kAgents = 1500;
  Flyers flyers = flyers_in_box(kAgents, 5, 5, 5);
  flyers.at.x[3] = 1e7F;
  flyers.at.y[4] = -1e7F;
  flyers.at.z[5] = 1e8F;
  flyers.at.x[6] = flyers.at.x[7] = 4000.0F;  // two who have each other
  flyers.at.y[6] = flyers.at.y[7] + 2.0F;
  SwarmModel model = test::forced_swarm(kAgents);
  test::give_zones(model, kAggregation);
  model.forces.friction = 1.0F;
  expect_as_reference(flyers, model, test::flown_a_second(*make_native_engine(2), model, flyers));
}

TEST(ForceZones, LetNobodyFlyFasterThanAllowed) {
  const Flyers flyers = flyers_in_box(500, 5, 5, 5);
  SwarmModel model = test::forced_swarm(500);
  test::give_zones(model, kMidges);
  model.field.most_speed = 2.0F;
  const Columns out = test::flown_a_second(*make_native_engine(1), model, flyers);
  std::size_t held = 0;
  for (std::size_t a = 0; a < 500; ++a) {
    const double speed = length({out.x[a], out.y[a], out.z[a]});
    EXPECT_LE(speed, 2.0 + 1e-5);
    held += speed > 2.0 - 1e-5 ? 1U : 0U;
  }
  EXPECT_GT(held, 250U);
}

}  // namespace
}  // namespace mayfly
