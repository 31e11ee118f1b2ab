// The lemmas of docs/explanation/safety.md about one robot: what braking keeps, and what holds what.
#include "controller/governor/reservation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "controller/governor/capsule.hpp"
#include "controller/governor/reference.hpp"
#include "tests/unit/governor/convex.hpp"

namespace mayfly::governor_test {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  glm::dvec3 vector(double size) {
    std::normal_distribution<double> normal(0.0, size);
    return {normal(random_), normal(random_), normal(random_)};
  }
  Braking braking() { return {std::pow(10.0, between(-1.0, 2.0)), between(0.05, 0.1), 0.0}; }

 private:
  std::mt19937_64 random_;
};

Hull command_hull(glm::dvec3 p, glm::dvec3 v, glm::dvec3 w, const Braking& braking) {
  Hull hull;
  add_command(hull, p, v, w, braking);
  return hull;
}

TEST(Reservation, BrakingTakesOneStepAndStopsAtRest) {
  EXPECT_EQ(brake({0, 0, 0}, 0.04), glm::dvec3(0));
  EXPECT_EQ(brake({0.04, 0, 0}, 0.04), glm::dvec3(0));
  EXPECT_EQ(brake({0, 0, -1.04}, 0.04), glm::dvec3(0, 0, -1.0));
  EXPECT_EQ(brake({1e-300, 0, 0}, 0.04), glm::dvec3(0));
}

TEST(Reservation, ARobotAtRestReservesItsPlace) {
  const Hull hull = command_hull({1, 2, 3}, {0, 0, 0}, {0, 0, 0}, {4.0, 0.01, 0.5});
  for (const glm::dvec3& point : hull.points()) {
    EXPECT_EQ(point, glm::dvec3(1, 2, 3));
  }
  EXPECT_EQ(stopping_distance(0.0, {4.0, 0.01, 0.5}), 0.0);
}

// Lemma 1: a tick of braking ends inside what was reserved, linearly or at once, and so does all that is
// reserved afterwards.
TEST(Reservation, BrakingShrinks) {
  Draw draw(3);
  for (int i = 0; i < 200000; ++i) {
    Braking braking = draw.braking();
    braking.watchdog = i % 2 == 0 ? 0.0 : draw.between(0.0, 1.0);
    const double speed = i % 3 == 0 ? draw.between(0.0, 2.0) * braking.step() : draw.between(0.0, 20.0);
    const double next = brake({speed, 0, 0}, braking.step()).x;
    ASSERT_LE(speed - next, braking.step() + 1e-14);
    ASSERT_GE(next, 0.0);
    const double reserved = stopping_distance(speed, braking);
    const double after = stopping_distance(next, braking);
    const double tolerance = 1e-12 * (1.0 + reserved);
    ASSERT_LE(braking.period * (speed + next) / 2.0 + after, reserved + tolerance);
    ASSERT_LE(braking.period * next + after, reserved + tolerance);
    const double way = speed > 0.0 ? stopping_way(Vec3<double>(speed, 0, 0), speed, braking.deceleration,
                                                  braking.period, braking.watchdog)
                                         .x
                                   : 0.0;
    ASSERT_NEAR(way, reserved, tolerance);
  }
}

// Lemma 2: whatever a robot does in a tick that ends at the command sooner than linearly or linearly, it
// stays within a_max·T²/8 of the hull.
TEST(Reservation, EveryWayThroughATickStaysInTheHull) {
  Draw draw(5);
  for (int i = 0; i < 300; ++i) {
    const Braking braking = draw.braking();
    const glm::dvec3 v = draw.vector(1.0);
    const glm::dvec3 w = v + draw.vector(0.2);
    const Hull hull = command_hull({0, 0, 0}, v, w, braking);
    const double arc = braking.period * length3(w - v) / 8.0;
    for (const double ramp : {1e-9, 0.3, 1.0}) {  // share of the tick until the velocity is w
      for (double t = 0.0; t <= 1.0; t += 0.125) {
        const double s = t < ramp ? t * t / (2.0 * ramp) : t - ramp / 2.0;
        const glm::dvec3 p = braking.period * (v * t + (w - v) * s);
        ASSERT_LE(distance_to_hull(p, hull.points()), arc + 1e-9);
      }
    }
  }
}

// Lemma 3: what is reserved after the tick, by whatever way it ended, lies in what was reserved for it.
TEST(Reservation, TheNextTicksBrakingLiesInThisTicksHull) {
  Draw draw(7);
  for (int i = 0; i < 300; ++i) {
    const Braking braking = draw.braking();
    const glm::dvec3 v = draw.vector(1.0);
    const glm::dvec3 w = i % 4 == 0 ? brake(v, braking.step()) : v + draw.vector(0.2);
    const Hull hull = command_hull({0, 0, 0}, v, w, braking);
    for (const double at_once : {0.0, 0.5, 1.0}) {
      const glm::dvec3 end = braking.period * (0.5 * (1.0 - at_once) * (v + w) + at_once * w);
      const Hull next = command_hull(end, w, brake(w, braking.step()), braking);
      for (const glm::dvec3& point : next.points()) {
        ASSERT_LE(distance_to_hull(point, hull.points()), 1e-9 * (1.0 + length3(point)));
      }
    }
  }
}

// Lemma 4: with a latency and a lag, what is reserved after a tick of any command lies in what was reserved
// for it, and the body lies in it for as long as the robot brakes from then on.
TEST(Reservation, TailsShrinkAndHoldTheBody) {
  Draw draw(9);
  for (int i = 0; i < 60; ++i) {
    const Braking braking{draw.between(1.0, 10.0), 0.02, 0.0};
    const int latency = i % 4;
    const ReferenceModel model{20.0, i % 3 == 0 ? 0.0 : 0.1};
    Reference reference(latency);
    reference.adopt({0, 0, 0}, glm::vec3(draw.vector(0.5)), model);
    Hull last;
    for (int tick = 0; tick < 30; ++tick) {
      const glm::dvec3 v(reference.velocity());
      const glm::vec3 w(tick < 15 ? v + draw.vector(0.05) : brake(v, braking.step()));
      Hull now;
      reference.add_tail(now, model);
      add_command(now, reference.lead(), v, glm::dvec3(w), braking);
      if (tick > 15) {
        for (const glm::dvec3& point : now.points()) {
          ASSERT_LE(distance_to_hull(point, last.points()), 1e-6) << tick;
        }
      }
      last = now;
      reference.advance(w, 0.02, model);
      ASSERT_LE(distance_to_hull(reference.body(), now.points()), 1e-9);
    }
  }
}

// Lemma 5: the capsule holds the hull.
TEST(Capsule, HoldsEveryCorner) {
  Draw draw(11);
  for (int i = 0; i < 2000; ++i) {
    std::vector<glm::dvec3> points(static_cast<std::size_t>(1 + i % 14));
    for (glm::dvec3& point : points) {
      point = i % 5 == 0 ? glm::dvec3(draw.between(-1.0, 1.0), 0, 0) : draw.vector(1.0);
    }
    const Capsule capsule = capsule_around(points);
    for (const glm::dvec3& point : points) {
      const glm::dvec3 ends[] = {capsule.a, capsule.b};
      ASSERT_LE(distance_to_hull(point, ends), capsule.radius + 1e-6);
    }
  }
}

TEST(Capsule, OfPointsInARowIsASegment) {
  const glm::dvec3 points[] = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const Capsule capsule = capsule_around(points);
  EXPECT_EQ(capsule.b, glm::dvec3(2, 0, 0));
  EXPECT_EQ(capsule.radius, 0.0);
}

}  // namespace
}  // namespace mayfly::governor_test
