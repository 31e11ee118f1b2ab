// Stopping paths that touch are found, by a sweep as by all pairs.
#include "controller/guard/separation_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>

namespace mayfly::test {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs found(SeparationWatch& watch, const std::vector<StoppingPath>& paths) {
  Pairs pairs;
  watch.check(paths, [&](std::uint32_t i, std::uint32_t j) {
    pairs.insert({std::min(i, j), std::max(i, j)});
  });
  return pairs;
}

// The least over a fine grid of both segments: never less than the truth.
double brute(const glm::dvec3& a0, const glm::dvec3& a1, const glm::dvec3& b0, const glm::dvec3& b1) {
  double least = INFINITY;
  for (int i = 0; i <= 100; ++i) {
    for (int j = 0; j <= 100; ++j) {
      least = std::min(least, glm::length(a0 + 0.01 * i * (a1 - a0) - b0 - 0.01 * j * (b1 - b0)));
    }
  }
  return least;
}

TEST(SegmentDistance, IsTheLeastOfAllPairsOfPoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const auto point = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  for (int trial = 0; trial < 300; ++trial) {
    const glm::dvec3 a0 = point();
    const glm::dvec3 b0 = point();
    // Points and parallels, too.
    const glm::dvec3 a1 = trial % 5 == 0 ? a0 : point();
    const glm::dvec3 b1 = trial % 7 == 0 ? b0 + (a1 - a0) : trial % 11 == 0 ? b0 : point();
    const double near = brute(a0, a1, b0, b1);
    const double told = segment_distance(a0, a1, b0, b1);
    EXPECT_LE(told, near + 1e-12);
    EXPECT_GE(told, near - 0.03) << trial;
  }
}

TEST(SeparationWatch, FindsWhatAllPairsFind) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 3.0);
  std::normal_distribution<double> step(0.0, 0.1);
  std::vector<StoppingPath> paths(60);
  for (StoppingPath& path : paths) {
    path.from = {place(random), place(random), place(random)};
    path.radius = 0.05 + 0.02 * place(random);
    path.downwash = random() % 2 == 0 ? 1.0 : 3.0;
    path.counts = random() % 8 != 0;
  }
  SeparationWatch watch(paths.size());
  std::size_t touching = 0;
  for (int tick = 0; tick < 200; ++tick) {
    for (StoppingPath& path : paths) {
      path.from += glm::dvec3(step(random), step(random), step(random));
      path.to = path.from + 2.0 * glm::dvec3(step(random), step(random), step(random));
    }
    Pairs expected;
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
      for (std::uint32_t j = i + 1; j < paths.size(); ++j) {
        const glm::dvec3 flat(1, 1, 1 / std::min(paths[i].downwash, paths[j].downwash));
        const double apart = segment_distance(paths[i].from * flat, paths[i].to * flat, paths[j].from * flat,
                                              paths[j].to * flat);
        if (paths[i].counts && paths[j].counts && apart < paths[i].radius + paths[j].radius - 2e-4) {
          expected.insert({i, j});
        }
      }
    }
    touching += expected.size();
    ASSERT_EQ(found(watch, paths), expected) << tick;
  }
  EXPECT_GT(touching, 100U) << "nothing was tested";
}

TEST(SeparationWatch, TellsTouchingFromAlmostTouching) {
  std::vector<StoppingPath> paths(2);
  for (StoppingPath& path : paths) {
    path.radius = 0.1;
    path.counts = true;
  }
  SeparationWatch watch(2);
  paths[1].from = paths[1].to = {0.2, 0, 0};
  EXPECT_TRUE(found(watch, paths).empty());
  paths[1].from = paths[1].to = {0.199, 0, 0};
  EXPECT_EQ(found(watch, paths).size(), 1U);
  paths[1].to = {5, 0, 0};  // where it goes does not help, as long as it is there
  EXPECT_EQ(found(watch, paths).size(), 1U);
}

}  // namespace
}  // namespace mayfly::test
