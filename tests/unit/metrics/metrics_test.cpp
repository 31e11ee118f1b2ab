#include "controller/metrics/metrics.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Columns {
  std::vector<float> x, y, z, vx, vy, vz;
  explicit Columns(std::size_t n) : x(n), y(n), z(n), vx(n), vy(n), vz(n) {}
  MetricsTick tick() const { return {x, y, z, vx, vy, vz}; }
};

MetricsConfig config_of(std::size_t agents) {
  MetricsConfig config;
  config.period = 10ms;
  config.radii.assign(agents, 0.05F);
  config.swarms = {{0, agents}};
  return config;
}

TEST(Metrics, NothingObservedIsNothingMeasured) {
  const Metrics metrics(config_of(2));
  const MetricsResult result = metrics.result();
  EXPECT_EQ(result.ticks, 0U);
  EXPECT_FALSE(result.min_separation_m || result.reached_fraction || result.max_speed_mps ||
               result.max_acceleration_mps2);
}

TEST(Metrics, NobodyAndOneAlone) {
  for (const std::size_t agents : {0U, 1U}) {
    Metrics metrics(config_of(agents));
    metrics.observe(Columns(agents).tick());
    const MetricsResult result = metrics.result();
    EXPECT_EQ(result.ticks, 1U);
    EXPECT_FALSE(result.min_separation_m.has_value());
    EXPECT_EQ(result.max_speed_mps.has_value(), agents == 1);
    EXPECT_FALSE(result.max_acceleration_mps2.has_value());  // one velocity has no change
  }
}

TEST(Metrics, SpeedAndAccelerationAreTheLargestOfAnyTick) {
  Metrics metrics(config_of(2));
  Columns columns(2);
  columns.x[1] = 4.0F;
  columns.vx[0] = 3.0F;
  columns.vy[0] = 4.0F;
  metrics.observe(columns.tick());
  columns.vx[0] = 0.0F;
  columns.vy[0] = 0.0F;
  columns.vz[1] = -1.0F;
  metrics.observe(columns.tick());
  const MetricsResult result = metrics.result();
  EXPECT_DOUBLE_EQ(*result.max_speed_mps, 5.0);
  EXPECT_DOUBLE_EQ(*result.max_acceleration_mps2, 500.0);
  EXPECT_DOUBLE_EQ(*result.min_separation_m, 4.0);
}

TEST(Metrics, NumbersThatAreNoneAreLeftOutAndCounted) {
  Metrics metrics(config_of(3));
  Columns columns(3);
  columns.x = {0.0F, 1.0F, kNan};
  columns.vx = {1.0F, kNan, kNan};
  metrics.observe(columns.tick());
  EXPECT_EQ(metrics.result().not_finite, 2U);  // agents 1 and 2, once each
  columns.x[2] = 3.0F;
  columns.vx = {1.0F, 100.0F, 0.0F};  // nobody knows how agent 1 came to be so fast
  metrics.observe(columns.tick());
  const MetricsResult result = metrics.result();
  EXPECT_EQ(result.not_finite, 2U);
  EXPECT_DOUBLE_EQ(*result.min_separation_m, 1.0);
  EXPECT_DOUBLE_EQ(*result.max_acceleration_mps2, 0.0);
  EXPECT_DOUBLE_EQ(*result.max_speed_mps, 100.0);
}

TEST(Metrics, ReachedMeansOnceAndBySwarm) {
  MetricsConfig config = config_of(4);
  config.swarms = {{0, 1}, {1, 3}};
  config.in_goal = [](std::size_t swarm, glm::vec3 p) { return swarm == 0 ? p.x > 10.0F : p.x < -10.0F; };
  Metrics metrics(config);
  Columns columns(4);
  columns.x = {11.0F, 11.0F, -11.0F, 0.0F};
  metrics.observe(columns.tick());
  columns.x = {0.0F, 1.0F, 2.0F, kNan};
  metrics.observe(columns.tick());
  const MetricsResult result = metrics.result();
  EXPECT_DOUBLE_EQ(*result.reached_fraction, 0.5);
  EXPECT_DOUBLE_EQ(result.reached_fraction_of.at(0).value(), 1.0);
  EXPECT_DOUBLE_EQ(result.reached_fraction_of.at(1).value(), 1.0 / 3.0);
}

TEST(Metrics, WithoutGoalsOrAgentsNoFractionIsMeasured) {
  Metrics goalless(config_of(2));
  goalless.observe(Columns(2).tick());
  EXPECT_FALSE(goalless.result().reached_fraction.has_value());
  MetricsConfig config = config_of(0);
  config.in_goal = [](std::size_t, glm::vec3) { return true; };
  Metrics empty(config);
  empty.observe(Columns(0).tick());
  EXPECT_FALSE(empty.result().reached_fraction.has_value());
  EXPECT_FALSE(empty.result().reached_fraction_of.at(0).has_value());
}

// A ball of 0.4 m amid cells of 1 m: the samples alone do not know it, and the exact distance is asked only
// near it.
TEST(Metrics, PenetrationsAreExactWhereTheFieldCannotTell) {
  const Grid grid{{-4.0F, -4.0F, -4.0F}, 1.0F, {8, 8, 8}};
  const auto ball = [](glm::vec3 p) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 0.4F; };
  std::vector<float> data(grid.size());
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (int i = 0; i < 8; ++i) {
        data[grid.index(i, j, k)] = ball(grid.center(i, j, k));
      }
    }
  }
  int asked = 0;
  MetricsConfig config = config_of(4);
  config.obstacles.sampled = {data.data(), grid};
  config.obstacles.exact = [&](glm::vec3 p) {
    ++asked;
    return ball(p);
  };
  Metrics metrics(config);
  Columns columns(4);
  columns.x = {0.39F, 0.4F, 0.41F, 3.0F};
  metrics.observe(columns.tick());
  metrics.observe(columns.tick());
  EXPECT_EQ(metrics.result().penetrations, 2U);  // one agent in two ticks; on the surface is not inside
  EXPECT_EQ(asked, 6);
}

TEST(Metrics, WallClearanceIsExactAndMeasuredWhereItIsAskedFor) {
  const Grid grid{{-4.0F, -4.0F, -4.0F}, 1.0F, {8, 8, 8}};
  const auto ball = [](glm::vec3 p) { return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z) - 0.4F; };
  std::vector<float> data(grid.size());
  for (std::size_t i = 0; i < data.size(); ++i) {
    const int n = static_cast<int>(i);
    data[i] = ball(grid.center(n % 8, n / 8 % 8, n / 64));
  }
  for (const bool asked : {false, true}) {
    MetricsConfig config = config_of(3);
    config.obstacles.sampled = {data.data(), grid};
    config.obstacles.exact = ball;
    config.wall_clearance = asked;
    Metrics metrics(config);
    Columns columns(3);
    columns.x = {3.0F, -2.3F, kNan};
    metrics.observe(columns.tick());
    columns.x = {1.1F, -2.3F, 3.5F};
    metrics.observe(columns.tick());
    columns.x = {2.0F, 3.0F, 3.5F};
    metrics.observe(columns.tick());
    ASSERT_EQ(metrics.result().wall_clearance_m.has_value(), asked);
    EXPECT_NEAR(metrics.result().wall_clearance_m.value_or(0.7), 0.7, 1e-6);
  }
  MetricsConfig nowhere = config_of(1);
  nowhere.wall_clearance = true;
  Metrics metrics(nowhere);
  metrics.observe(Columns(1).tick());
  EXPECT_FALSE(metrics.result().wall_clearance_m.has_value());  // there are no obstacles
}

TEST(Metrics, ShortColumnsLeaveTheRestOut) {
  Metrics metrics(config_of(3));
  Columns columns(3);
  columns.x = {0.0F, 2.0F, 2.5F};
  columns.y.resize(2);
  metrics.observe(columns.tick());
  EXPECT_DOUBLE_EQ(*metrics.result().min_separation_m, 2.0);
}

TEST(Metrics, ObservingAllocatesNothing) {
  MetricsConfig config = config_of(100);
  config.in_goal = [](std::size_t, glm::vec3) { return false; };
  Metrics metrics(config);
  const Columns columns(100);
  const std::uint64_t before = allocation_count();
  metrics.observe(columns.tick());
  metrics.observe(columns.tick());
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly
