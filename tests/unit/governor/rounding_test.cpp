// The rounding margins are held: what is computed in double is compared with intervals that hold what is
// true.
#include <gtest/gtest.h>

#include <boost/numeric/interval.hpp>
#include <cmath>
#include <random>

#include "controller/governor/capsule.hpp"
#include "controller/governor/group_model.hpp"
#include "controller/governor/margins.hpp"
#include "controller/governor/reservation.hpp"
#include "tests/unit/governor/rig.hpp"

namespace mayfly::governor_test {
namespace {

using boost::numeric::interval;
using True = interval<double>;

// Of the formulas that decide: everything between the coordinates that come in and the gap that is compared.
template <class S>
struct Chain {
  Vec3<S> end, stop;  // of a tick, and where it would rest
  S spread, gap, size;
};

struct Case {
  glm::dvec3 p, v, w, q0, q1, n;
  double t;
};

template <class S>
Vec3<S> exact(glm::dvec3 v) {
  return {S(v.x), S(v.y), S(v.z)};
}

template <class S>
Chain<S> compute(const Case& c, double braking, double period) {
  Chain<S> chain;
  const Vec3<S> p = exact<S>(c.p);
  const Vec3<S> w = exact<S>(c.w);
  chain.end = p + (exact<S>(c.v) + w) * (S(0.5) * S(period));
  chain.stop = chain.end + stopping_way(w, length3(w), S(braking), S(period), S(0.1));
  chain.spread = distance_at(chain.end, p, chain.stop, c.t);
  chain.gap = gap_along(exact<S>(c.n), p, chain.stop, exact<S>(c.q0), exact<S>(c.q1));
  chain.size = length3(exact<S>(c.n));
  return chain;
}

// How far a double may be from what is true, m.
double off(double computed, const True& truth) {
  return std::fmax(std::fabs(computed - truth.lower()), std::fabs(computed - truth.upper()));
}

TEST(Rounding, OfTheGeometryStaysWithinItsMargin) {
  std::mt19937_64 random(1);
  double worst = 0.0;  // of the margin
  for (int n = 0; n < 200000; ++n) {
    const double extent = std::pow(10.0, std::uniform_real_distribution<double>(0.0, 4.0)(random));
    std::uniform_real_distribution<double> place(-0.5 * extent, 0.5 * extent);
    std::uniform_real_distribution<double> speed(-0.2, 0.2);
    const auto anywhere = [&] { return glm::dvec3(place(random), place(random), place(random)); };
    const auto velocity = [&] { return glm::dvec3(speed(random), speed(random), speed(random)); };
    const glm::dvec3 v = velocity();
    const Case c{anywhere(), v, v + 0.1 * velocity(), anywhere(), anywhere(), anywhere(), 0.37};
    const Chain<double> computed = compute<double>(c, 4.0, 0.01);
    const Chain<True> truth = compute<True>(c, 4.0, 0.01);
    const double gap = off(computed.gap, truth.gap) / truth.size.lower();
    const double distance = off(computed.spread, truth.spread);
    const double place_off = std::fmax(off(computed.stop.x, truth.stop.x), off(computed.end.y, truth.end.y));
    worst = std::fmax(worst, (gap + distance + place_off) / geometry_rounding(extent));
    ASSERT_LE(worst, 1.0) << extent;
  }
  EXPECT_GE(worst, 0.02);  // and it is not larger than it need be by orders of magnitude
}

// Commands are floats: what a robot reserves while it brakes may leave what it had reserved, tick after tick.
TEST(Rounding, OfCommandsWhileBrakingStaysWithinItsMargin) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const double period : {0.001, 0.01, 0.02}) {
    for (int n = 0; n < 200; ++n) {
      GovernorLimits limits;
      limits.speed = 5.0F;
      limits.braking = limits.acceleration = n % 2 == 0 ? 4.0F : 19.0F;
      const Braking braking{limits.braking, period, 0.0};
      const glm::dvec3 way(normal(random), normal(random), normal(random));
      glm::dvec3 v(glm::vec3(way * (4.999 / length3(way))));
      glm::dvec3 p(0.0);
      const glm::dvec3 along = v / length3(v);
      const double reserved = stopping_distance(length3(v), braking);
      double most = 0.0;
      while (length3(v) > 0.0) {
        const glm::dvec3 w(glm::vec3(brake(v, braking.step())));
        p += 0.5 * period * (v + w);
        v = w;
        const double speed = length3(v);
        const glm::dvec3 stop =
            speed > 0.0 ? p + stopping_way(v, speed, braking.deceleration, period, 0.0) : p;
        for (const glm::dvec3& corner : {p, stop}) {
          const double t = dot3(corner, along);
          most = std::fmax(most, std::fmax(length3(corner - t * along), t - reserved));
        }
      }
      ASSERT_LE(most, braking_rounding(limits, period));
    }
  }
}

TEST(Rounding, OfPosesAsFloatsStaysWithinAQuarterOfItsMargin) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-100.0, 100.0);
  for (int n = 0; n < 100000; ++n) {
    const glm::dvec3 p(place(random), place(random), place(random));
    ASSERT_LE(length3(p - glm::dvec3(glm::vec3(p))), 0.25 * pose_rounding(100.0));
  }
}

TEST(Rounding, TheArcIsWhatThePhysicsSays) {
  GovernorLimits limits;
  limits.acceleration = 8.0F;
  EXPECT_DOUBLE_EQ(arc_height(limits, 0.1), 0.01);
}

// The smallest of them is 1e-13 m: no flight would miss it.
TEST(Rounding, EveryMarginIsKeptAroundAReservation) {
  GovernorConfig config = default_config(1);
  GovernorLimits& limits = config.groups[0].limits;
  limits.radius = 0.125F;
  limits.tube = 0.25F;
  limits.watchdog = 0.1F;
  const GroupModel group = make_group_model(config.groups[0], config);
  const double margins = arc_height(limits, 0.01) + pose_rounding(10.0) + braking_rounding(limits, 0.01) +
                         geometry_rounding(10.0 + group.usual_reach());
  EXPECT_NEAR(group.kept - 0.375, margins, 1e-15);
  EXPECT_NEAR(group.clearance.hard, group.kept, 0.0);
  EXPECT_NEAR(group.clearance.slack, 0.0125 + 0.625 * 0.01 * 0.04, 1e-15) << "a tenth of the body, the chord";
}

}  // namespace
}  // namespace mayfly::governor_test
