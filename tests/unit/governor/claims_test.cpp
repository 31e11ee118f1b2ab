// What a claim holds, and what obstacles leave free: the parts that only a corner case reaches.
#include "controller/governor/claims.hpp"

#include <cmath>
#include <limits>

#include "controller/governor/clearance.hpp"
#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

// Lemma 4: what was told late may be flown late, so who is behind keeps off where the robot was.
TEST(Claims, TheTailIsKept) {
  for (const int latency : {2, 4}) {
    GovernorConfig config = default_config(2);
    config.groups[0].count = 1;
    config.groups.push_back(config.groups[0]);
    config.groups[1].first = 1;
    config.groups[0].limits.latency = latency;
    Rig rig(config);
    rig.place(0, {-2, 0, 0}, {2, 0, 0});
    rig.known[1] = 0;
    for (int tick = 0; tick < 20; ++tick) {
      rig.tick({2, 0, 0});
      rig.measured = {0, 1};
    }
    rig.known[1] = 1;
    rig.place(1, {-1.6F - 0.25F, 0, 0}, {0, 0, 0});  // 0.02 m a tick: it was 0.04 or 0.08 m nearer
    rig.tick({2, 0, 0});
    EXPECT_NEAR(rig.governor.reference(0).body.x, -1.6, 1e-6);
    EXPECT_EQ(rig.symptoms[1].has(Symptom::kTooNear), latency == 4);
  }
}

TEST(Claims, WhoIsNotPresentIsNearNobody) {
  Hull hull;
  hull.add({0, 0, 0});
  Claim mine;
  mine.present = true;
  mine.kept = 0.1;
  const Wish wish{mine, hull, hull, {0, 0, 0}, 0.0};
  Claim other = mine;
  const std::uint32_t first = 0;
  EXPECT_EQ(nearness(wish, mine, {&other, 1}, {&first, 1}), Nearness::kTooNear);
  other.present = false;
  EXPECT_EQ(nearness(wish, mine, {&other, 1}, {&first, 1}), Nearness::kApart);
}

TEST(Clearance, ADistanceThatIsNoNumberClearsNothing) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const float far = 9.0F;
  const Capsule capsule{{0, 0, 0}, {1, 0, 0}, 0.1};
  const Grid grid{{-1, -1, -1}, 2.0F, {1, 1, 1}};
  ObstacleView obstacles{.sampled = {&none, grid}};
  EXPECT_FALSE(clear_of_obstacles(capsule, obstacles, {0.1, 0.0}));
  obstacles.sampled.data = &far;
  EXPECT_TRUE(clear_of_obstacles(capsule, obstacles, {0.1, 0.0}));
}

TEST(Clearance, OfACapsuleIsThatOfItsSurface) {
  const float nothing = 0.0F;
  ObstacleView obstacles{.sampled = {&nothing, Grid{{-1, -1, -1}, 2.0F, {1, 1, 1}}}};
  obstacles.exact = [](glm::vec3 p) { return 1.0F - p.x; };
  for (const double radius : {0.49, 0.51}) {
    const Capsule capsule{{-1, 0, 0}, {0, 0, 0}, radius};
    EXPECT_EQ(clear_of_obstacles(capsule, obstacles, {0.4, 0.1}), radius < 0.5);
  }
}

// A sheet at x = 0: from one side of it the other is farther away, and not to be reached.
TEST(Clearance, TheWayOutDoesNotLeadThroughTheObstacle) {
  const float nothing = 0.0F;
  ObstacleView obstacles{.sampled = {&nothing, Grid{{-1, -1, -1}, 2.0F, {1, 1, 1}}}};
  obstacles.exact = [](glm::vec3 p) { return std::fabs(p.x); };
  for (const double end : {-1.0, 1.0}) {
    Hull hull;
    for (std::size_t n = 0; n < kCommandPoints; ++n) {
      hull.add({n == 0 ? -0.1 : end, 0, 0});
    }
    EXPECT_EQ(leaves_obstacle(hull, {-0.1, 0, 0}, 0.0, obstacles, {0.2, 0.01}), end < 0.0);
  }
}

// Where there is room for a proof, nothing else will do.
TEST(Clearance, WhoIsFarFromAnObstacleDoesNotLeaveIt) {
  const float nothing = 0.0F;
  ObstacleView obstacles{.sampled = {&nothing, Grid{{-1, -1, -1}, 2.0F, {1, 1, 1}}}};
  obstacles.exact = [](glm::vec3 p) { return std::fabs(p.x); };
  for (const double from : {0.21, 0.23}) {
    Hull hull;
    for (std::size_t n = 0; n < kCommandPoints; ++n) {
      hull.add({n == 0 ? from : 1.0, 0, 0});
    }
    EXPECT_EQ(leaves_obstacle(hull, {from, 0, 0}, 0.0, obstacles, {0.2, 0.01}), from < 0.22);
  }
}

TEST(Clearance, AlongAnObstacleIsNotAwayFromIt) {
  const float nothing = 0.0F;
  ObstacleView obstacles{.sampled = {&nothing, Grid{{-1, -1, -1}, 2.0F, {1, 1, 1}}}};
  obstacles.exact = [](glm::vec3 p) { return std::fabs(p.x); };
  for (const double away : {0.05, 0.2}) {  // of a metre along it; a tenth is asked for
    Hull hull;
    for (std::size_t n = 0; n < kCommandPoints; ++n) {
      hull.add({n == 0 ? 0.1 : 0.1 + away, n == 0 ? 0.0 : 1.0, 0});
    }
    EXPECT_EQ(leaves_obstacle(hull, {0.1, 0, 0}, 0.0, obstacles, {0.2, 0.01}), away > 0.1);
  }
}

}  // namespace
}  // namespace mayfly::governor_test
