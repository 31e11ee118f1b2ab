// What pulls and drives away: straight to prey, off from predators at an angle of the encounter's own.
#include "kernels/stimulus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "tests/reference/forces_reference.hpp"
#include "tests/unit/kernels/lanes.hpp"

namespace mayfly {
namespace {

using reference::length;
using reference::Vec3;

constexpr double kPi = 3.14159265358979323846;

kernels::F3 all_lanes(Vec3 v) {
  return test::all_lanes({v.x, v.y, v.z});
}
Vec3 lane(kernels::F3 v) {
  return {v.x[0], v.y[0], v.z[0]};
}

kernels::MfStimulus stimulus(int kind) {
  return {kind, 1, 2, 3, 60, 5, 0, 0};
}

// θ of eight agents' encounters, rad.
std::array<double, 8> angles(kernels::uint key, int first_agent, int encounter) {
  const kernels::MfMoment moment{key, ~key, {}, {}};
  const kernels::F turns = kernels::mf_flight_turns(&moment, kernels::mf_lane_index() + first_agent,
                                                    kernels::mf_isplat(encounter), 0);
  std::array<double, 8> all{};
  for (std::size_t k = 0; k < 8; ++k) {
    all[k] = 2 * kPi * static_cast<double>(turns[k]);
  }
  return all;
}

TEST(Stimulus, DrawsStraightToPreyWithinReach) {
  const kernels::MfStimulus prey = stimulus(MF_STIMULUS_PREY);
  for (const double distance : {0.01, 1.0, 4.99}) {
    const Vec3 r{1 + 0.6 * distance, 2, 3 - 0.8 * distance};
    const auto force = lane(kernels::mf_stimulus_force(all_lanes(r), all_lanes({}), &prey, kernels::F{}));
    EXPECT_LE(length(force - Vec3{-0.6 * 60, 0, 0.8 * 60}), 1e-3) << distance;
  }
  for (const Vec3 r : {Vec3{1, 7.01, 3}, Vec3{1, 2, 3}}) {
    EXPECT_EQ(length(lane(kernels::mf_stimulus_force(all_lanes(r), all_lanes({}), &prey, kernels::F{}))), 0);
  }
}

TEST(Stimulus, TurnsThoseWhoFleeAboutTheVertical) {
  const kernels::MfStimulus predator = stimulus(MF_STIMULUS_PREDATOR);
  for (const double angle : {0.0, -0.3, -1.0, -kPi / 2}) {
    const auto turns = kernels::mf_splat(static_cast<float>(angle / (2 * kPi)));
    const auto force =
        lane(kernels::mf_stimulus_force(all_lanes({3, 1, 4}), all_lanes({}), &predator, turns));
    const auto away = reference::turned(reference::unit({2, -1, 1}), angle);
    EXPECT_LE(length(force - 60 * away), 1e-3) << angle;
  }
}

TEST(Stimulus, AheadIsEachAgentsOwn) {
  kernels::MfStimulus ahead = stimulus(MF_STIMULUS_AHEAD);
  ahead.distance = 2;
  for (const double turn : {0.0, 0.5, -2.0, 7.0}) {
    ahead.turn = static_cast<float>(turn);
    const auto force = lane(
        kernels::mf_stimulus_force(all_lanes({50, 60, 70}), all_lanes({3, -1, 0.5}), &ahead, kernels::F{}));
    const auto to = reference::turned(reference::unit({3, -1, 0.5}), turn);
    EXPECT_LE(length(force - 60 * to), 1e-3) << turn;
  }
  ahead.distance = 6;  // out of reach
  EXPECT_EQ(
      length(lane(kernels::mf_stimulus_force(all_lanes({}), all_lanes({3, 0, 0}), &ahead, kernels::F{}))), 0);
  ahead.distance = 2;  // nobody's heading
  EXPECT_EQ(length(lane(kernels::mf_stimulus_force(all_lanes({}), all_lanes({}), &ahead, kernels::F{}))), 0);
}

TEST(Encounters, AreCountedWhenTheyBegin) {
  kernels::I state = kernels::mf_isplat(0);
  const auto see = [&](bool within) {
    state = kernels::mf_after_encounter(state, kernels::mf_isplat(within ? -1 : 0));
    return state[0] >> 1;
  };
  EXPECT_EQ(see(false), 0);
  EXPECT_EQ(see(true), 1);
  EXPECT_EQ(see(true), 1);
  EXPECT_EQ(see(false), 1);
  EXPECT_EQ(see(false), 1);
  EXPECT_EQ(see(true), 2);
}

// Uniform in [−π/2, 0]: ten bins of equal share, and no two agents or encounters alike.
TEST(Encounters, HaveAnglesOfTheirOwn) {
  std::array<int, 10> bins{};
  std::set<double> seen;
  constexpr int kAgents = 8000;
  for (int agent = 0; agent < kAgents; agent += 8) {
    for (const double angle : angles(99, agent, 1)) {
      ASSERT_GE(angle, -kPi / 2);
      ASSERT_LE(angle, 0);
      seen.insert(angle);
      ++bins[std::min<std::size_t>(9, static_cast<std::size_t>(-angle / (kPi / 2) * 10))];
    }
  }
  for (const int bin : bins) {
    EXPECT_NEAR(bin, 0.1 * kAgents, 120);
  }
  EXPECT_GT(seen.size(), kAgents - 20U);
  EXPECT_NE(angles(99, 0, 1), angles(99, 0, 2));
  EXPECT_NE(angles(99, 0, 1), angles(98, 0, 1));
  EXPECT_EQ(angles(99, 0, 1), angles(99, 0, 1));
}

}  // namespace
}  // namespace mayfly
