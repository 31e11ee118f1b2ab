// Who is near whom, and whether two capsules are apart: against all pairs, and against an independent search.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "controller/governor/capsule.hpp"
#include "controller/governor/neighbour_cells.hpp"

namespace mayfly::governor_test {
namespace {

using Ball = NeighbourCells::Ball;

std::vector<std::uint32_t> brute_force(std::size_t i, const std::vector<Ball>& balls) {
  std::vector<std::uint32_t> near;
  for (std::uint32_t j = 0; j < balls.size(); ++j) {
    const double reach = balls[i].radius + balls[j].radius;
    if (j != i && balls[j].radius >= 0.0 && length3(balls[j].center - balls[i].center) <= reach) {
      near.push_back(j);
    }
  }
  return near;
}

// Some lie outside the box of this half side, some need more than is usual, some nothing.
std::vector<Ball> some_balls(std::size_t count, float side, std::mt19937_64& random) {
  std::normal_distribution<double> place(0.0, 0.7 * static_cast<double>(side));
  std::vector<Ball> balls(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = i % 17 == 3 ? 5.0 : (i % 11 == 5 ? -1.0 : static_cast<double>(i % 10) / 9.0);
    balls[i] = {{place(random), place(random), place(random)}, radius};
  }
  return balls;
}

void expect_all_pairs(NeighbourCells& cells, const std::vector<Ball>& balls) {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].radius >= 0.0) {
      const auto found = cells.near(i, balls);
      std::vector<std::uint32_t> near(found.begin(), found.end());
      std::sort(near.begin(), near.end());
      ASSERT_EQ(near, brute_force(i, balls));
    }
  }
}

TEST(NeighbourCells, FindWhatAllPairsFind) {
  std::mt19937_64 random(1);
  for (const std::size_t count : {0U, 1U, 2U, 300U}) {
    for (const float side : {0.1F, 8.0F, 1000.0F}) {
      NeighbourCells cells(count, {glm::vec3(-side), glm::vec3(side)}, 1.0);
      for (int round = 0; round < 3; ++round) {
        const std::vector<Ball> balls = some_balls(count, side, random);
        cells.sort(balls);
        expect_all_pairs(cells, balls);
      }
    }
  }
}

TEST(NeighbourCells, PlacesThatAreHugeHaveACellToo) {
  NeighbourCells cells(3, {glm::vec3(0.0F), glm::vec3(10.0F)}, 1.0);
  const std::vector<Ball> balls{{{1e30, -1e30, 5.0}, 1.0}, {{1e30, -1e30, 5.0}, 1.0}, {{5, 5, 5}, 1.0}};
  cells.sort(balls);
  EXPECT_EQ(cells.near(0, balls).size(), 1U);
  EXPECT_EQ(cells.near(2, balls).size(), 0U);
}

// By sampling one axis, and the exact distance of a point to the other.
double sampled_distance(const Capsule& p, const Capsule& q) {
  double least = 1e300;
  const glm::dvec3 way = q.b - q.a;
  for (int k = 0; k <= 4000; ++k) {
    const glm::dvec3 x = p.a + (p.b - p.a) * (k / 4000.0);
    const double squared = dot3(way, way);
    const double t = squared > 0.0 ? std::clamp(dot3(x - q.a, way) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, distance_at(x, q.a, q.b, t));
  }
  return least;
}

TEST(Capsule, DistancesAreFoundAndCertified) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 1.0);
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  for (int n = 0; n < 2000; ++n) {
    Capsule p{vector(), vector(), 0.0};
    Capsule q{vector(), vector(), 0.0};
    if (n % 5 == 1) {
      p.b = p.a;
    }
    if (n % 7 == 1) {
      q.b = q.a;
    }
    if (n % 3 == 1) {
      q.b = q.a + 0.5 * (p.b - p.a);  // parallel
    }
    const double distance = sampled_distance(p, q);
    ASSERT_NEAR(length3(nearest_way(p, q)), distance, 2e-3);
    ASSERT_LE(length3(nearest_way(p, q)), distance + 1e-12);
    ASSERT_FALSE(apart(p, q, distance + 1e-9));
    if (distance > 0.01) {
      ASSERT_TRUE(apart(p, q, length3(nearest_way(p, q)) * (1.0 - 1e-9))) << n;
    }
  }
}

TEST(Capsule, WhatMeetsIsNotApart) {
  const Capsule p{{0, 0, 0}, {1, 0, 0}, 0.0};
  EXPECT_FALSE(apart(p, p, 0.0));
  EXPECT_FALSE(apart(p, {{0.5, -1, 0}, {0.5, 1, 0}, 0.0}, 0.0));
  EXPECT_FALSE(apart({{1, 1, 1}, {1, 1, 1}, 0.0}, {{1, 1, 1}, {1, 1, 1}, 0.0}, 0.0));
  EXPECT_TRUE(apart(p, {{2, 0, 0}, {3, 0, 0}, 0.0}, 1.0));
  EXPECT_EQ(flattened({{1, 2, 3}, {4, 5, 6}, 7.0}, 0.5).b, glm::dvec3(4, 5, 3));
}

}  // namespace
}  // namespace mayfly::governor_test
