#include "controller/metrics/near_pairs.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "tests/reference/all_pairs.hpp"
#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Crowd {
  std::vector<float> x, y, z, radii;

  explicit Crowd(std::size_t n, float radius = 0.0F) : x(n), y(n), z(n), radii(n, radius) {}
  void observe(NearPairs& pairs) const { pairs.observe(x, y, z); }
  void place(std::size_t i, float px, float py, float pz) { x[i] = px, y[i] = py, z[i] = pz; }
};

struct Walk {
  std::size_t agents;
  float box;     // m
  float step;    // m a tick, standard deviation
  float radius;  // m, the largest; the others are drawn below it
};

class NearPairsWalk : public testing::TestWithParam<Walk> {};

TEST_P(NearPairsWalk, AgreesWithAllPairs) {
  const Walk walk = GetParam();
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    std::normal_distribution<float> step(0.0F, walk.step);
    Crowd crowd(walk.agents);
    for (std::size_t i = 0; i < walk.agents; ++i) {
      crowd.place(i, walk.box * unit(random), walk.box * unit(random), walk.box * (unit(random) - 0.5F));
      crowd.radii[i] = walk.radius * unit(random);
    }
    NearPairs pairs(crowd.radii);
    reference::AllPairs all;
    for (int tick = 0; tick < 60; ++tick) {
      crowd.observe(pairs);
      all.observe(crowd.x, crowd.y, crowd.z, crowd.radii);
      ASSERT_EQ(pairs.min_distance(), all.min_distance) << "seed " << seed << " tick " << tick;
      ASSERT_EQ(pairs.encounters(), all.encounters);
      for (auto* column : {&crowd.x, &crowd.y, &crowd.z}) {
        for (float& value : *column) {
          value += step(random);
        }
      }
    }
    EXPECT_EQ(pairs.overflows(), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Walks, NearPairsWalk,
                         testing::Values(Walk{2, 1.0F, 0.1F, 0.2F}, Walk{3, 100.0F, 5.0F, 0.0F},
                                         Walk{100, 5.0F, 0.1F, 0.1F}, Walk{100, 5.0F, 0.1F, 0.0F},
                                         Walk{300, 1000.0F, 30.0F, 10.0F}, Walk{50, 1e-3F, 1e-4F, 1e-5F},
                                         Walk{200, 1e7F, 1e5F, 1.0F}, Walk{60, 1.0F, 0.5F, 0.05F}));

TEST(NearPairs, NobodyAndOneAloneHaveNoDistance) {
  for (const std::size_t n : {0U, 1U}) {
    const Crowd crowd(n);
    NearPairs pairs(crowd.radii);
    crowd.observe(pairs);
    EXPECT_EQ(pairs.min_distance(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(pairs.encounters(), 0U);
  }
}

TEST(NearPairs, CoincidentAgentsAreAtDistanceZero) {
  for (const float radius : {0.0F, 0.1F}) {
    Crowd crowd(3, radius);
    crowd.place(2, 5, 5, 5);
    NearPairs pairs(crowd.radii);
    crowd.observe(pairs);
    crowd.observe(pairs);  // a reach of nothing, if they have no radius
    EXPECT_EQ(pairs.min_distance(), 0.0);
    EXPECT_EQ(pairs.encounters(), radius > 0.0F ? 1U : 0U);
  }
}

TEST(NearPairs, TouchingMeansNearerThanTheRadiiNotAsNear) {
  Crowd crowd(2, 0.5F);
  crowd.place(1, 1, 0, 0);
  NearPairs pairs(crowd.radii);
  crowd.observe(pairs);
  EXPECT_EQ(pairs.encounters(), 0U);
  crowd.place(1, std::nextafter(1.0F, 0.0F), 0, 0);
  crowd.observe(pairs);
  EXPECT_EQ(pairs.encounters(), 1U);
}

TEST(NearPairs, AnEncounterCountsOnceHoweverLongItLasts) {
  Crowd crowd(2, 0.5F);
  NearPairs pairs(crowd.radii);
  const float distances[] = {2.0F, 0.9F, 0.5F, 0.9F, 1.5F, 0.9F, 1.5F};
  const std::uint64_t counts[] = {0, 1, 1, 1, 1, 2, 2};
  for (int tick = 0; tick < 7; ++tick) {
    crowd.place(1, distances[tick], 0, 0);
    crowd.observe(pairs);
    EXPECT_EQ(pairs.encounters(), counts[tick]) << tick;
  }
  EXPECT_EQ(pairs.min_distance(), 0.5);
}

TEST(NearPairs, WhatIsNotFiniteIsLeftOut) {
  Crowd crowd(4, 0.5F);
  crowd.place(0, kNan, 0, 0);
  crowd.place(1, 0, std::numeric_limits<float>::infinity(), 0);
  crowd.place(2, 0, 0, 0);
  crowd.place(3, 3, 0, 0);
  NearPairs pairs(crowd.radii);
  crowd.observe(pairs);
  EXPECT_EQ(pairs.min_distance(), 3.0);
  EXPECT_EQ(pairs.encounters(), 0U);
}

TEST(NearPairs, HugeCoordinatesAreStillExact) {
  Crowd crowd(4);
  crowd.place(0, 3e38F, -3e38F, 3e38F);
  crowd.place(1, -3e38F, 3e38F, -3e38F);
  crowd.place(2, 1e-30F, 0, 0);
  crowd.place(3, 0, 0, 0);
  NearPairs pairs(crowd.radii);
  for (int tick = 0; tick < 3; ++tick) {
    crowd.observe(pairs);
    EXPECT_EQ(pairs.min_distance(), static_cast<double>(1e-30F));
  }
}

// A pair that nearly coincides makes cells so small that those of the others are beyond what can be counted.
TEST(NearPairs, AHairsBreadthBesideFarAgentsIsExact) {
  Crowd crowd(4, 0.0F);
  crowd.place(0, 1e-12F, -1e-12F, 0);
  crowd.place(2, 1e6F, -1e6F, 3.7e5F);
  crowd.place(3, -1e6F, 1e6F, 8.1e5F);
  NearPairs pairs(crowd.radii);
  reference::AllPairs all;
  for (int tick = 0; tick < 3; ++tick) {
    crowd.observe(pairs);
    all.observe(crowd.x, crowd.y, crowd.z, crowd.radii);
    EXPECT_EQ(pairs.min_distance(), all.min_distance);
  }
}

// One far outlier must not make everybody everybody's neighbour: the result stays right, and the work linear.
TEST(NearPairs, AClusterBesideAnOutlierIsExact) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<float> unit(0.0F, 1e-3F);
  Crowd crowd(500);
  for (std::size_t i = 1; i < 500; ++i) {
    crowd.place(i, unit(random), unit(random), unit(random));
  }
  crowd.place(0, 1e6F, 0, 0);
  NearPairs pairs(crowd.radii);
  reference::AllPairs all;
  crowd.observe(pairs);
  all.observe(crowd.x, crowd.y, crowd.z, crowd.radii);
  EXPECT_EQ(pairs.min_distance(), all.min_distance);
}

TEST(NearPairs, MoreContactsThanThereIsRoomForAreReported) {
  Crowd crowd(40, 0.5F);  // 780 pairs, room for 320
  NearPairs pairs(crowd.radii);
  crowd.observe(pairs);
  EXPECT_EQ(pairs.overflows(), 1U);
  EXPECT_EQ(pairs.min_distance(), 0.0);
  for (std::size_t i = 0; i < 40; ++i) {
    crowd.place(i, 2.0F * static_cast<float>(i), 0, 0);
  }
  crowd.observe(pairs);
  EXPECT_EQ(pairs.overflows(), 1U);
}

TEST(NearPairs, ObservingAllocatesNothing) {
  std::mt19937_64 random(4);
  std::normal_distribution<float> normal(0.0F, 1.0F);
  Crowd crowd(200, 0.1F);
  NearPairs pairs(crowd.radii);
  const std::uint64_t before = allocation_count();
  for (int tick = 0; tick < 50; ++tick) {
    for (std::size_t i = 0; i < 200; ++i) {
      crowd.place(i, normal(random), normal(random), normal(random));
    }
    crowd.observe(pairs);
  }
  EXPECT_EQ(allocation_count(), before);
  EXPECT_GT(pairs.encounters(), 0U);
}

}  // namespace
}  // namespace mayfly
