#include "controller/governor/reservation.hpp"

#include <gtest/gtest.h>

#include <random>

namespace mayfly {
namespace {

constexpr double kPeriod = 0.01;

// safety.md §1.2, the lemma: one braking tick stays inside S, and what is reserved afterwards is part of it.
TEST(Reservation, BrakingStaysInsideWhatWasReserved) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 200000; ++i) {
    const double braking = std::pow(10.0, 3.0 * unit(random) - 1.0);
    const double speed = i % 3 == 0 ? unit(random) * 2.0 * braking * kPeriod : 20.0 * unit(random);
    const glm::dvec3 velocity(speed, 0.0, 0.0);
    const glm::dvec3 next = brake(velocity, braking * kPeriod);
    ASSERT_LE(speed - next.x, braking * kPeriod + 1e-14);
    ASSERT_GE(next.x, 0.0);
    const double reserved = stopping_distance(speed, braking, kPeriod);
    const double after = stopping_distance(next.x, braking, kPeriod);
    const double tolerance = 1e-12 * (1.0 + reserved);
    ASSERT_LE(kPeriod * (speed + next.x) / 2.0 + after, reserved + tolerance);  // linear change
    ASSERT_LE(kPeriod * next.x + after, reserved + tolerance);                  // at once
  }
}

TEST(Reservation, ARobotAtRestReservesItsPlace) {
  const Reservation r = reserve({1, 2, 3}, {0, 0, 0}, {0, 0, 0}, 4.0, kPeriod);
  EXPECT_EQ(r.end_linear, glm::dvec3(1, 2, 3));
  EXPECT_EQ(r.end_at_once, glm::dvec3(1, 2, 3));
  EXPECT_EQ(r.stop, glm::dvec3(0));
  EXPECT_EQ(r.sag, 0.0);
  EXPECT_EQ(stopping_distance(0.0, 4.0, kPeriod), 0.0);
}

// The parabola of a linear change of velocity, and everything between it and a change at once, stays within
// the sag.
TEST(Reservation, TheSagCoversEveryWayThroughTheTick) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  const auto vector = [&] { return glm::dvec3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 v = vector();
    const glm::dvec3 w = v + 0.1 * vector();
    const Reservation r = reserve({0, 0, 0}, v, w, 4.0, kPeriod);
    for (const double ramp : {1e-9, 0.3, 1.0}) {  // share of the tick until the velocity is w
      for (double t = 0.0; t <= 1.0; t += 0.125) {
        const double s = t < ramp ? t * t / (2.0 * ramp) : t - ramp / 2.0;
        const glm::dvec3 p = kPeriod * (v * t + (w - v) * s);
        const glm::dvec3 chord = r.end_linear;
        const double along = std::fmin(1.0, std::fmax(0.0, glm::dot(p, chord) / glm::dot(chord, chord)));
        ASSERT_LE(glm::length(p - along * chord), r.sag * (1.0 + 1e-9));
      }
    }
  }
}

}  // namespace
}  // namespace mayfly
