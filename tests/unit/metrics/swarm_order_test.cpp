// Swarms whose order is known by construction: rings, flights in one direction, clouds.
#include "controller/metrics/swarm_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using Kind = MotionQuestion::Kind;

struct Columns {
  explicit Columns(std::size_t n) : x(n), y(n), z(n), vx(n), vy(n), vz(n) {}
  void set(std::size_t i, glm::dvec3 p, glm::dvec3 v) {
    x[i] = static_cast<float>(p.x);
    y[i] = static_cast<float>(p.y);
    z[i] = static_cast<float>(p.z);
    vx[i] = static_cast<float>(v.x);
    vy[i] = static_cast<float>(v.y);
    vz[i] = static_cast<float>(v.z);
  }
  MetricsTick tick() const { return {x, y, z, vx, vy, vz}; }
  LastSeen seen() const {
    LastSeen seen(x.size());
    seen.update(tick());
    return seen;
  }
  std::vector<float> x, y, z, vx, vy, vz;
};

// Agents on a circle about `centre`, each at an angle `turned` (rad) from its tangent.
Columns ring(std::size_t n, glm::dvec3 centre, double turned, double way_round = 1.0) {
  Columns columns(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double heading = a + way_round * (0.5 * std::numbers::pi + turned);
    columns.set(i, centre + 3.0 * glm::dvec3(std::cos(a), std::sin(a), 0.0),
                (1.0 + static_cast<double>(i)) * glm::dvec3(std::cos(heading), std::sin(heading), 0.2));
  }
  return columns;
}

TEST(Polarisation, IsOneWhereAllFlyTheSameWayHoweverFast) {
  Columns columns(5);
  for (std::size_t i = 0; i < 5; ++i) {
    columns.set(i, glm::dvec3(static_cast<double>(i)), (1.0 + static_cast<double>(i)) * glm::dvec3(1, -2, 3));
  }
  EXPECT_NEAR(polarisation(columns.seen(), {0, 5}).value(), 1.0, 1e-6);
}

TEST(Polarisation, IsZeroWherePairsFlyApartAndCountsThoseThatStand) {
  Columns columns(4);
  columns.set(0, {}, {0.0, 2.0, 0.0});
  columns.set(1, {}, {0.0, -7.0, 0.0});
  EXPECT_NEAR(polarisation(columns.seen(), {0, 2}).value(), 0.0, 1e-9);
  columns.set(1, {}, {0.0, 1.0, 0.0});
  EXPECT_NEAR(polarisation(columns.seen(), {0, 4}).value(), 0.5, 1e-9);
  EXPECT_FALSE(polarisation(columns.seen(), {0, 0}));
}

TEST(Milling, IsOneOnARingWhicheverWayRoundAndWherever) {
  EXPECT_NEAR(milling(ring(12, glm::dvec3(0.0), 0.0).seen(), {0, 12}).value(), 1.0, 1e-6);
  EXPECT_NEAR(milling(ring(12, glm::dvec3(50, -30, 9), 0.0, -1.0).seen(), {0, 12}).value(), 1.0, 1e-5);
  EXPECT_NEAR(milling(ring(12, glm::dvec3(0.0), 1.0).seen(), {0, 12}).value(), std::cos(1.0), 1e-6);
  EXPECT_NEAR(milling(ring(12, glm::dvec3(0.0), 0.5 * std::numbers::pi).seen(), {0, 12}).value(), 0.0, 1e-6);
}

TEST(Milling, IsNothingForOneAndEmptyForNobody) {
  Columns columns(1);
  columns.set(0, {1, 2, 3}, {1, 0, 0});
  EXPECT_EQ(milling(columns.seen(), {0, 1}), 0.0);
  EXPECT_FALSE(milling(columns.seen(), {0, 0}));
}

double nearest_of_all_pairs(const Columns& c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < c.x.size(); ++j) {
      const double dx = static_cast<double>(c.x[i]) - static_cast<double>(c.x[j]);
      const double dy = static_cast<double>(c.y[i]) - static_cast<double>(c.y[j]);
      const double dz = static_cast<double>(c.z[i]) - static_cast<double>(c.z[j]);
      least = i == j ? least : std::min(least, std::sqrt(dx * dx + dy * dy + dz * dz));
    }
    sum += least;
  }
  return sum / static_cast<double>(c.x.size());
}

TEST(NearestDistance, EqualsAllPairs) {
  std::mt19937 random(7);
  for (const std::size_t n : {2U, 3U, 17U, 500U}) {
    for (const double flat : {1.0, 0.0}) {
      Columns columns(n);
      std::uniform_real_distribution<double> anywhere(-5.0, 5.0);
      for (std::size_t i = 0; i < n; ++i) {
        const double far = i % 7 == 0 ? 1000.0 : 1.0;  // outliers
        columns.set(i, {far * anywhere(random), anywhere(random), flat * anywhere(random)}, {});
      }
      EXPECT_NEAR(NearestDistance(n).mean(columns.seen(), {0, n}).value(), nearest_of_all_pairs(columns),
                  1e-9);
    }
  }
}

TEST(NearestDistance, KnowsAgentsAtOnePlaceAndThoseOnALattice) {
  Columns together(64);
  EXPECT_EQ(NearestDistance(64).mean(together.seen(), {0, 64}), 0.0);
  Columns lattice(64);
  for (std::size_t i = 0; i < 64; ++i) {
    const std::size_t row = i / 4;
    const std::size_t layer = i / 16;
    lattice.set(i, 0.5 * glm::dvec3(i % 4, row % 4, layer), {});
  }
  EXPECT_DOUBLE_EQ(NearestDistance(64).mean(lattice.seen(), {0, 64}).value(), 0.5);
  EXPECT_FALSE(NearestDistance(64).mean(lattice.seen(), {0, 1}));
}

TEST(SwarmOrder, IsAskedOfTheSecondHalfAndOfThoseWhoAreThere) {
  SwarmOrder order({{Kind::kPolarisation, 0, 2}, {Kind::kNone, 0, 2}, {Kind::kNearest, 0, 3}}, 10);
  LastSeen seen(3);
  Columns columns(3);
  std::vector<std::uint8_t> present{1, 1, 0};
  for (int tick = 0; tick < 10; ++tick) {
    columns.set(0, {0, 0, 0}, {1, 0, 0});
    columns.set(1, {2, 0, 0}, {tick < 5 ? -1.0 : 1.0, 0, 0});
    columns.set(2, {0.1, 0, 0}, {});
    MetricsTick now = columns.tick();
    now.present = present;
    seen.update(now);
    const std::uint64_t before = allocation_count();
    order.observe(seen);
    EXPECT_EQ(allocation_count(), before);
  }
  const auto answers = order.answers();
  EXPECT_NEAR(answers.at(0).value(), 1.0, 1e-9);
  EXPECT_FALSE(answers.at(1));
  EXPECT_NEAR(answers.at(2).value(), 2.0, 1e-6);
}

}  // namespace
}  // namespace mayfly
