// The models that are compared: what each is meant to do, and that nobody cheats.
#include "bench/noise/steering.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "bench/noise/neighbours.hpp"
#include "bench/noise/track.hpp"
#include "core/cache_directory.hpp"

namespace mayfly::bench {
namespace {

const Arena& arena() {
  static const auto kMade = make_arena();
  if (!kMade) {
    ADD_FAILURE() << to_string(kMade.error().front());
    std::abort();
  }
  return *kMade;
}

TEST(Neighbours, AreTheSameAsAmongAllPairs) {
  const auto points = arena().starts(400, 3);
  const Neighbours neighbours(points, 4.0F);
  for (const glm::vec3 from : {points[0], points[399], glm::vec3(-3, 7.9, 12), glm::vec3(500, 0, 0)}) {
    std::vector<std::size_t> found, wanted;
    neighbours.for_each(from, 3.5F, [&](std::size_t p, float) { found.push_back(p); });
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (glm::distance(points[p], from) < 3.5F) {
        wanted.push_back(p);
      }
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, wanted);
  }
}

class Steered : public testing::TestWithParam<SteeredBy> {};

TEST_P(Steered, FliesThroughThePassageAndIntoNoBlock) {
  const Flown flown = fly_model(arena(), GetParam(), NoiseKind::kWhite, 40, 4500, 1);
  for (std::size_t tick = 0; tick <= flown.ticks(); tick += 20) {
    for (const glm::vec3 p : flown.places(tick)) {
      EXPECT_GT(arena().world.solid.signed_distance(p), 0.0F);
    }
  }
  for (const glm::vec3 p : flown.places(flown.ticks())) {
    EXPECT_GT(p.y, 64.0F) << "behind the blocks";
  }
}

TEST_P(Steered, GetsTheNoiseThatItIsSaidToGet) {
  const double rms = static_cast<double>(arena().noise(NoiseKind::kCurl, 1).rms_speed);
  for (const NoiseKind kind : {NoiseKind::kCurl, NoiseKind::kPerlin, NoiseKind::kWhite}) {
    // At first all are in the open, and wherever they started.
    const Flown flown = fly_model(arena(), GetParam(), kind, 300, 20, 1);
    double square = 0;
    for (const glm::vec3 v : flown.noise) {
      square += static_cast<double>(glm::dot(v, v));
    }
    // 300 agents' noise, which a frozen one hardly changes in 20 ticks: 1/√(4 · 300), three times.
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(flown.noise.size())) / rms, 1, 0.09);
  }
  const Flown none = fly_model(arena(), GetParam(), NoiseKind::kNone, 300, 20, 1);
  for (const glm::vec3 v : none.noise) {
    EXPECT_LT(glm::length(v), 1e-5F);
  }
}

TEST_P(Steered, RepeatsItself) {
  const Flown a = fly_model(arena(), GetParam(), NoiseKind::kWhite, 20, 100, 7);
  const Flown b = fly_model(arena(), GetParam(), NoiseKind::kWhite, 20, 100, 7);
  EXPECT_EQ(a.at, b.at);
  EXPECT_NE(a.at, fly_model(arena(), GetParam(), NoiseKind::kWhite, 20, 100, 8).at);
  EXPECT_EQ(fly_model(arena(), GetParam(), NoiseKind::kCurl, 0, 10, 1).ticks(), 0U);
}
INSTANTIATE_TEST_SUITE_P(Models, Steered,
                         testing::Values(SteeredBy::kPath, SteeredBy::kBoids, SteeredBy::kCrowd));

TEST(Boids, SeparateAlignAndCohere) {
  const auto boids = make_boids(arena());
  // Two pairs in the open: one too near each other, one within sight only.
  const std::vector<glm::vec3> at{{30, 10, 20}, {30.4F, 10, 20}, {30, 10, 35}, {33, 10, 35}};
  std::vector<glm::vec3> velocity(4);
  boids->steer(at, velocity);
  EXPECT_LT(velocity[0].x, velocity[1].x) << "apart";
  EXPECT_GT(velocity[2].x, velocity[3].x) << "together";
  for (const glm::vec3 v : velocity) {
    EXPECT_NEAR(glm::length(v), 1.5F, 1e-4F) << "at its own speed";
  }
}

TEST(Crowd, IsSlowerWhereItIsDense) {
  const auto sparse = make_crowd(arena());
  const auto dense = make_crowd(arena());
  std::vector<glm::vec3> one{{30, 9, 20}}, many(40, {30, 9, 20});
  std::vector<glm::vec3> fast(1), slow(40);
  sparse->steer(one, fast);
  dense->steer(many, slow);
  EXPECT_GT(fast[0].y, 1.2F);
  EXPECT_LT(glm::length(slow[0]), 0.6F * glm::length(fast[0]));
}

}  // namespace
}  // namespace mayfly::bench
