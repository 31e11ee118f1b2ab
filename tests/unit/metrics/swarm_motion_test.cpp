// Swarms whose motion is known by construction: circles, shifts, growing clouds.
#include "controller/metrics/swarm_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Columns {
  explicit Columns(std::size_t n) : x(n), y(n), z(n) {}
  void set(std::size_t i, glm::dvec3 p) {
    x[i] = static_cast<float>(p.x);
    y[i] = static_cast<float>(p.y);
    z[i] = static_cast<float>(p.z);
  }
  std::vector<float> x, y, z;
};

MotionQuestion ask(Kind kind, std::size_t count, glm::dvec3 place = glm::dvec3(0.0)) {
  return {kind, 0, count, [place] { return place; }};
}

// Flies `ticks` ticks with agents where `place(agent, share of the flight)` has them.
template <class Place>
std::optional<double> answer(const MotionQuestion& question, std::uint64_t ticks, Place place) {
  SwarmMotion motion({question}, ticks);
  LastSeen seen(question.count);
  Columns columns(question.count);
  for (std::uint64_t tick = 0; tick < ticks; ++tick) {
    for (std::size_t i = 0; i < question.count; ++i) {
      columns.set(i, place(i, static_cast<double>(tick) / static_cast<double>(ticks)));
    }
    seen.update({columns.x, columns.y, columns.z, {}, {}, {}});
    motion.observe(seen);
  }
  return motion.answers().at(0);
}

glm::dvec3 on_circle(glm::dvec3 axis, double radius, double turns) {
  const double angle = 2.0 * std::numbers::pi * turns;
  return axis + glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 3.0 * turns);
}

TEST(Turns, AreCountedWhicheverWayAndWhereverTheAxis) {
  for (const double turns : {0.0, 0.3, 1.0, 7.25, -2.5}) {
    for (const glm::dvec3 axis : {glm::dvec3(0.0), glm::dvec3(40.0, -7.0, 12.0)}) {
      const auto value = answer(ask(Kind::kTurns, 9, axis), 1001, [&](std::size_t i, double share) {
        const double part = share * 1001.0 / 1000.0;
        return on_circle(axis, 1.0 + static_cast<double>(i), 0.1 * static_cast<double>(i) + turns * part);
      });
      EXPECT_NEAR(value.value(), std::fabs(turns), 1e-5) << turns;
    }
  }
}

TEST(Turns, OneWayTakesBackTheOther) {
  const auto value = answer(ask(Kind::kTurns, 2), 1000, [](std::size_t i, double share) {
    const double there_and_back = share < 0.5 ? share : 1.0 - share;
    return on_circle(glm::dvec3(0.0), 2.0, i == 0 ? 4.0 * there_and_back : 4.0 * share);
  });
  EXPECT_NEAR(value.value(), 2.0, 0.01);  // the mean of 0 and 4
}

TEST(Turns, SurviveTheAxisItselfAndTicksWithoutAPlace) {
  const auto value = answer(ask(Kind::kTurns, 1), 1001, [](std::size_t, double share) {
    const auto tick = static_cast<int>(std::lround(share * 1001.0));
    if (tick % 10 == 3) {
      return glm::dvec3(0.0);  // right on it
    }
    return tick % 10 == 7 ? glm::dvec3(std::nan("")) : on_circle(glm::dvec3(0.0), 2.0, tick / 1000.0);
  });
  EXPECT_NEAR(value.value(), 1.0, 1e-5);
}

TEST(Drift, IsTheFarthestOfTheCentreAndNoTurning) {
  const auto value = answer(ask(Kind::kCentreDrift, 8), 500, [](std::size_t i, double share) {
    const glm::dvec3 shift = share < 0.5 ? glm::dvec3(6.0, 8.0, 0.0) * share : glm::dvec3(0.0);
    return shift + on_circle(glm::dvec3(5.0), 3.0 + share, static_cast<double>(i) / 8.0 + share) -
           glm::dvec3(0.0, 0.0, 3.0 * share);
  });
  EXPECT_NEAR(value.value(), 10.0 * 0.498, 1e-4);
  // The same agents, all still.
  EXPECT_NEAR(answer(ask(Kind::kCentreDrift, 8), 500,
                     [](std::size_t i, double) { return glm::dvec3(static_cast<double>(i)); })
                  .value(),
              0.0, 1e-12);
}

TEST(Drift, DoesNotJumpWhereAnAgentIsNotSeen) {
  const auto value = answer(ask(Kind::kCentreDrift, 2), 100, [](std::size_t i, double share) {
    return i == 1 && share > 0.3 ? glm::dvec3(std::nan("")) : glm::dvec3(static_cast<double>(i) * 100.0);
  });
  EXPECT_EQ(value.value(), 0.0);
}

TEST(Spread, IsTheRadiusOfGyrationAtTheEnd) {
  const auto value = answer(ask(Kind::kSpread, 8), 1000, [](std::size_t i, double share) {
    const double half = share < 0.9 ? 50.0 : 2.0;  // a cube's corners, √3 · 2 from the middle
    const auto side = [&](unsigned bit) { return (i >> bit & 1U) != 0 ? half : -half; };
    return glm::dvec3(100.0 * share) + glm::dvec3(side(0), side(1), side(2));
  });
  EXPECT_NEAR(value.value(), std::sqrt(12.0), 1e-4);
}

TEST(Distance, FollowsAPlaceThatMovesAndLeavesOutTheFirstHalf) {
  glm::dvec3 goal(0.0);
  MotionQuestion question{Kind::kDistance, 0, 4, [&goal] { return goal; }};
  SwarmMotion motion({question}, 100);
  LastSeen seen(4);
  Columns columns(4);
  for (int tick = 0; tick < 100; ++tick) {
    goal = glm::dvec3(tick, 2.0 * tick, 0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const double away = tick < 50 ? 1000.0 : static_cast<double>(i);  // 0, 1, 2, 3
      columns.set(i, goal + glm::dvec3(0.0, 0.0, away));
    }
    seen.update({columns.x, columns.y, columns.z, {}, {}, {}});
    motion.observe(seen);
  }
  EXPECT_NEAR(motion.answers().at(0).value(), 1.5, 1e-5);
}

TEST(SwarmMotion, KeepsToItsSwarmAndItsOrder) {
  MotionQuestion second = ask(Kind::kSpread, 2);
  second.first = 2;
  SwarmMotion motion({ask(Kind::kNone, 2), second, ask(Kind::kSpread, 2)}, 1);
  LastSeen seen(4);
  const Columns columns = [] {
    Columns c(4);
    c.x = {0.0F, 2.0F, 0.0F, 20.0F};
    return c;
  }();
  seen.update({columns.x, columns.y, columns.z, {}, {}, {}});
  motion.observe(seen);
  const auto answers = motion.answers();
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_FALSE(answers[0]);
  EXPECT_DOUBLE_EQ(answers[1].value(), 10.0);
  EXPECT_DOUBLE_EQ(answers[2].value(), 1.0);
}

TEST(SwarmMotion, NobodyOneAndNeverSeen) {
  const auto still = [](std::size_t, double) { return glm::dvec3(1.0, 2.0, 3.0); };
  const auto unseen = [](std::size_t, double) { return glm::dvec3(std::nan("")); };
  for (const Kind kind : {Kind::kCentreDrift, Kind::kDistance, Kind::kTurns, Kind::kSpread}) {
    EXPECT_FALSE(answer(ask(kind, 0), 10, still));
    EXPECT_FALSE(answer(ask(kind, 3), 10, unseen));
    EXPECT_FALSE(SwarmMotion({ask(kind, 3)}, 10).answers().at(0) && kind != Kind::kTurns);
    EXPECT_NEAR(answer(ask(kind, 1), 10, still).value(), kind == Kind::kDistance ? std::sqrt(14.0) : 0.0,
                1e-6);
  }
  SwarmMotion short_columns({ask(Kind::kSpread, 3)}, 1);
  LastSeen seen(3);
  const std::vector<float> two = {0.0F, 2.0F};
  const std::vector<float> partly = {0.0F, kNan};
  seen.update({two, two, partly, {}, {}, {}});
  short_columns.observe(seen);
  EXPECT_EQ(short_columns.answers().at(0), 0.0);  // one agent was seen
}

TEST(SwarmMotion, ObservingAllocatesNothing) {
  SwarmMotion motion(
      {ask(Kind::kTurns, 50), ask(Kind::kSpread, 50), ask(Kind::kDistance, 50), ask(Kind::kCentreDrift, 50)},
      1);
  LastSeen seen(50);
  const Columns columns(50);
  const std::uint64_t before = allocation_count();
  seen.update({columns.x, columns.y, columns.z, {}, {}, {}});
  motion.observe(seen);
  seen.update({columns.x, columns.y, columns.z, {}, {}, {}});
  motion.observe(seen);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly
