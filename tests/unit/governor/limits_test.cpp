// What contradicts itself, and where the promise cannot begin, is refused with the inequality.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::function<void(GovernorConfig&)>& change) {
  GovernorConfig config = default_config(2);
  change(config);
  const auto made = Governor::make(config);
  return made ? "" : made.error().message + ": " + made.error().found + ", " + made.error().wanted;
}
GovernorLimits& limits(GovernorConfig& config) {
  return config.groups[0].limits;
}

TEST(GovernorLimits, OfBodiesAndLinksAreChecked) {
  EXPECT_EQ(refusal([](auto&) {}), "");
  EXPECT_THAT(refusal([](auto& c) { limits(c).watchdog = -1.0F; }), HasSubstr("watchdog"));
  EXPECT_THAT(refusal([](auto& c) { limits(c).response_time = NAN; }), HasSubstr("response time"));
  EXPECT_THAT(refusal([](auto& c) { limits(c).latency = 9; }), HasSubstr("9 ticks, 0 to 8 ticks"));
  EXPECT_THAT(refusal([](auto& c) { limits(c).latency = -1; }), HasSubstr("-1 ticks"));
  EXPECT_EQ(refusal([](auto& c) { limits(c).latency = 8; }), "");
  EXPECT_THAT(refusal([](auto& c) { limits(c).downwash = 0.9F; }), HasSubstr("0.9, >= 1"));
  EXPECT_THAT(refusal([](auto& c) { limits(c).downwash = INFINITY; }), HasSubstr("downwash"));
}

TEST(GovernorLimits, ASeparationBelowTwoRadiiAndTubesIsRefused) {
  const auto separated = [](float separation) {
    return refusal([&](auto& c) {
      limits(c).tube = 0.05F;
      c.groups[0].separation = separation;
    });
  };
  EXPECT_EQ(separated(0.31F), "");
  EXPECT_EQ(separated(0.0F), "");  // nobody said
  EXPECT_THAT(separated(0.29F), HasSubstr("separation = 0.29 m, >= 2 · (radius 0.1 + tube 0.05) = 0.3 m"));
}

TEST(GovernorLimits, AWatchdogBeyondTheSeparationIsRefused) {
  const auto watched = [](float watchdog) {
    return refusal([&](auto& c) {
      limits(c).watchdog = watchdog;
      c.groups[0].separation = 0.5F;
    });
  };
  EXPECT_EQ(watched(0.25F), "");
  EXPECT_THAT(watched(0.26F), HasSubstr("speed 2 · watchdog 0.26 = 0.52 m, <= separation = 0.5 m"));
}

TEST(GovernorLimits, AFenceSmallerThanAStoppingDistanceIsRefused) {
  const auto tall = [](float height) {
    return refusal([&](auto& c) { c.fence.max.z = c.fence.min.z + height; });
  };
  EXPECT_EQ(tall(0.71F), "");  // 0.2 m for the body, 0.5 m to stop from 2 m/s
  EXPECT_THAT(tall(0.69F), HasSubstr("smaller than a stopping distance"));
  EXPECT_THAT(tall(0.69F), HasSubstr("0.69 m along z"));
}

TEST(GovernorLimits, HalfSpacesMustLeaveRoom) {
  const auto above = [](glm::vec3 normal, float offset) {
    return refusal([&](auto& c) { c.half_spaces = {{normal, offset}}; });
  };
  EXPECT_EQ(above({0, 0, 2}, 0.0F), "");
  EXPECT_EQ(above({1, 1, 1}, -25.0F), "");  // a corner that just holds a body
  EXPECT_THAT(above({0, 0, 1}, -9.9F), HasSubstr("leave no room"));
  EXPECT_THAT(above({0, 0, 0}, 1.0F), HasSubstr("no direction"));
  EXPECT_THAT(above({0, NAN, 0}, 1.0F), HasSubstr("no direction"));
  EXPECT_THAT(above({0, 0, 1}, NAN), HasSubstr("no direction"));
}

TEST(GovernorFence, AHalfSpaceIsKept) {
  GovernorConfig config = default_config(1);
  config.half_spaces = {{{3, 4, 0}, 5.0F}};  // 0.6 x + 0.8 y <= 1
  Rig rig(config);
  for (int i = 0; i < 300; ++i) {
    rig.tick({1.2F, 1.6F, 0});
    rig.fly(0);
  }
  const double along = 0.6 * static_cast<double>(rig.x[0]) + 0.8 * static_cast<double>(rig.y[0]);
  EXPECT_LE(along, 0.9);
  EXPECT_GE(along, 0.88);
}

std::string not_admitted(const Rig& rig) {
  const auto admitted = rig.governor.admit(rig.state());
  if (admitted) {
    return "";
  }
  const Error& error = admitted.error().error;
  return error.message + ": " + error.found + ", " + error.wanted;
}

TEST(Admission, ASafeStartIsAdmitted) {
  Rig rig(default_config(2));
  rig.place(1, {0.201F, 0, 0}, {0, 0, 0});
  EXPECT_EQ(not_admitted(rig), "");
  EXPECT_EQ(rig.governor.counters().ticks, 0U);
  EXPECT_FALSE(rig.governor.reference(0).known);
}

TEST(Admission, TheFirstPairThatIsTooNearIsNamed) {
  Rig rig(default_config(4));
  rig.place(1, {2, 0, 0}, {0, 0, 0});
  rig.place(2, {4, 0, 0}, {0, 0, 0});
  rig.place(3, {2.15F, 0, 0}, {0, 0, 0});
  EXPECT_THAT(not_admitted(rig), HasSubstr("robot 1 and robot 3 start too near"));
  EXPECT_THAT(not_admitted(rig), HasSubstr("0.1500 m"));
  EXPECT_THAT(not_admitted(rig), HasSubstr("= 0.200"));
  const auto named =
      rig.governor.admit(rig.state(), [](std::size_t agent) { return "flies_" + std::to_string(agent); });
  ASSERT_FALSE(named);
  EXPECT_EQ(named.error().agent, 1U);
  EXPECT_EQ(named.error().error.message, "flies_1 and flies_3 start too near to each other");
  rig.authority[3] = Authority::kAbsent;
  EXPECT_EQ(not_admitted(rig), "");
}

TEST(Admission, HeightsCountAsTheyAreKept) {
  GovernorConfig config = default_config(2);
  config.groups[0].limits.downwash = 3.0F;
  Rig rig(config);
  rig.place(1, {0, 0, 0.5F}, {0, 0, 0});
  EXPECT_THAT(not_admitted(rig), HasSubstr("heights divided by 3"));
}

TEST(Admission, WhoCannotStopInsideTheFenceIsNamed) {
  Rig rig(default_config(1));
  rig.place(0, {9.8F, 0, 0}, {1, 0, 0});
  EXPECT_THAT(not_admitted(rig), HasSubstr("robot 0 starts where it cannot stop inside the fence"));
}

TEST(Admission, WhoseObstacleIsTooNearIsNamed) {
  GovernorConfig config = default_config(2);
  const float nothing = 0.0F;
  config.obstacles.sampled = {&nothing, Grid{{-10, -10, -10}, 20.0F, {1, 1, 1}}};
  config.obstacles.exact = [](glm::vec3 p) { return 1.0F - p.x; };
  Rig rig(config);
  rig.place(0, {0.8F, 0, 0}, {0, 0, 0});
  rig.place(1, {0.95F, 5, 0}, {0, 0, 0});
  EXPECT_THAT(not_admitted(rig), HasSubstr("robot 1 starts too near to an obstacle: 0.05"));
}

TEST(Admission, NobodyStartsUnseenOrWithoutARow) {
  Rig rig(default_config(2));
  rig.place(1, {1, 0, 0}, {0, 0, 0});
  rig.known[1] = 0;
  EXPECT_THAT(not_admitted(rig), HasSubstr("nobody knows where robot 1 is"));
  rig.authority.pop_back();
  EXPECT_THAT(not_admitted(rig), HasSubstr("too few rows"));
}

TEST(Admission, AnUngovernedSwarmIsNobodysAffair) {
  GovernorConfig config = default_config(2);
  config.groups[0].enabled = false;
  Rig rig(config);
  EXPECT_EQ(not_admitted(rig), "");
}

}  // namespace
}  // namespace mayfly::governor_test
