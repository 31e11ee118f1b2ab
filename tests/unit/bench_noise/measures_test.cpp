#include "bench/noise/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace mayfly::bench {
namespace {

constexpr double kCruise = 1.5;

// A flight of `agents` along place(agent, time in s); `noise` is all of its velocity.
template <class PlaceOf>
Flown flight(std::size_t agents, std::size_t ticks, PlaceOf place) {
  Flown flown;
  flown.agents = agents;
  for (std::size_t tick = 0; tick <= ticks; ++tick) {
    for (std::size_t a = 0; a < agents; ++a) {
      const glm::dvec3 now = place(a, static_cast<double>(tick) * kPeriod);
      flown.at.push_back(glm::vec3(now));
      if (tick < ticks) {
        flown.noise.push_back(glm::vec3((place(a, static_cast<double>(tick + 1) * kPeriod) - now) / kPeriod));
      }
    }
  }
  return flown;
}

TEST(Measures, OfAStraightFlight) {
  const Measures m = measure(flight(3, 1000,
                                    [](std::size_t a, double t) {
                                      return glm::dvec3(100.0 * static_cast<double>(a), kCruise * t, 5);
                                    }),
                             kCruise)
                         .measures;
  EXPECT_NEAR(m.tortuosity, 1, 1e-4);
  EXPECT_NEAR(m.progress, 1, 1e-4);
  EXPECT_NEAR(m.noise_reach, 1, 1e-4);
  EXPECT_EQ(m.stuck_share, 0);
  EXPECT_EQ(m.near_share, 0);
  EXPECT_LT(m.turning_rate, 0.1);
}

TEST(Measures, OfACircle) {
  // A turn of 4 rad/s for all, so that only the first window's edges tell; half a circle's way in π/4 s.
  const auto circling = [](std::size_t a, double t) {
    return glm::dvec3(100.0 * static_cast<double>(a) + std::cos(4 * t), std::sin(4 * t), 5);
  };
  const Measures m = measure(flight(2, 1000, circling), kCruise).measures;
  EXPECT_NEAR(m.turning_rate, 4, 0.01);
  EXPECT_EQ(m.stuck_share, std::sqrt(2 - 2 * std::cos(20.0)) < 1 ? 1 : 0) << "the chord of the last 5 s";
  // |∫v dt| over a second is the chord 2 sin 2, of a way of 4 m.
  EXPECT_NEAR(m.noise_reach, 2 * std::sin(2.0) / 4, 1e-3);
  EXPECT_NEAR(m.tortuosity, 40 / (2 * std::fabs(std::sin(20.0))), 0.1);
}

TEST(Measures, OfASwayTellItsFrequency) {
  constexpr double kHz = 12.5;
  const auto swaying = [](std::size_t, double t) {
    return glm::dvec3(0.002 * std::sin(2 * std::numbers::pi * kHz * t), kCruise * t, 5);
  };
  const Measures m = measure(flight(1, 1100, swaying), kCruise).measures;
  EXPECT_NEAR(m.turning_hz, kHz, 0.2);
  EXPECT_LT(m.turning_high, 0.01);
}

TEST(Measures, OfWhoStands) {
  std::mt19937 engine(1);
  std::normal_distribution<double> rounding(0, 1e-6);
  const auto standing = [&](std::size_t a, double) {
    return glm::dvec3(10.0 * static_cast<double>(a) + rounding(engine), rounding(engine), 5);
  };
  const Measures m = measure(flight(4, 600, standing), kCruise).measures;
  EXPECT_EQ(m.stuck_share, 1);
  EXPECT_EQ(m.turning_rate, 0) << "who stands has no heading";
  EXPECT_NEAR(m.progress, 0, 1e-5);
}

glm::dvec3 random_place(std::size_t agent, double side) {
  std::mt19937 engine(static_cast<unsigned>(agent) * 7919U + 13U);
  std::uniform_real_distribution<double> coordinate(0, side);
  const double x = coordinate(engine), y = coordinate(engine);
  return {x, y, coordinate(engine)};
}

TEST(Measures, ClumpingIsOneByChance) {
  // 6 000 in 60 m: 0.028/m³, and 348 pairs within 1 m, whose count deviates by 1/√348. Near the faces both
  // balls lose volume, the larger one more: 4 m/60 m/… of 3/16 each of six faces, 7 %.
  const Measures m =
      measure(flight(6000, 50, [](std::size_t a, double) { return random_place(a, 60); }), kCruise).measures;
  EXPECT_NEAR(m.clumping, 1.07, 3 / std::sqrt(348.0));
  // Poisson: 1/√mean neighbours, 0.93 of them in 2 m.
  EXPECT_NEAR(m.density_variation, 1 / std::sqrt(6000.0 / 216000 * 4 / 3 * std::numbers::pi * 8), 0.06);
}

TEST(Measures, ClumpingTellsPairs) {
  // Pairs 0.1 m apart, 3 m from the next: each sees one within 1 m.
  const auto paired = [](std::size_t a, double) {
    const std::size_t pair = a / 2;
    return glm::dvec3(100 * static_cast<double>(pair), a % 2 == 0 ? 0.0 : 0.1, 0);
  };
  const Measures m = measure(flight(20, 50, paired), kCruise).measures;
  EXPECT_EQ(m.near_share, 1);
  EXPECT_NEAR(m.clumping, 64, 1e-9) << "all that is within 4 m is within 1 m";
}

TEST(Measures, OfNobodyAreNothing) {
  EXPECT_EQ(measure(Flown{}, kCruise).measures.clumping, 0);
}

}  // namespace
}  // namespace mayfly::bench
