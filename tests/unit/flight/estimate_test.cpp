#include "controller/flight/estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace mayfly {
namespace {

using namespace std::chrono_literals;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Writes robot a's sample: everything it holds is `value`, plus 1 for each column.
void report(const StateColumns& to, std::size_t a, float value, Time stamp, std::uint8_t valid = 1) {
  to.x[a] = value;
  to.y[a] = value + 1;
  to.z[a] = value + 2;
  to.vx[a] = value + 3;
  to.vy[a] = value + 4;
  to.vz[a] = value + 5;
  to.stamp[a] = stamp;
  to.valid[a] = valid;
}

TEST(Estimate, KnowsNobodyBeforeTheFirstSample) {
  Estimate estimate(2);
  EXPECT_EQ(estimate.update(), std::nullopt);
  EXPECT_EQ(estimate.valid, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(estimate.fresh, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_TRUE(std::isnan(estimate.x[0])) << "nobody may take it for a place";
}

TEST(Estimate, TakesEveryColumnOfAGoodSample) {
  Estimate estimate(2);
  report(estimate.inbox(), 1, 10, 7ms);
  EXPECT_EQ(estimate.update(), std::nullopt);
  EXPECT_EQ(estimate.valid, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(estimate.x[1], 10);
  EXPECT_EQ(estimate.y[1], 11);
  EXPECT_EQ(estimate.z[1], 12);
  EXPECT_EQ(estimate.vx[1], 13);
  EXPECT_EQ(estimate.vy[1], 14);
  EXPECT_EQ(estimate.vz[1], 15);
  EXPECT_EQ(estimate.stamp[1], Time(7ms));
  EXPECT_EQ(estimate.fresh, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Estimate, KeepsTheLastStateAndItsStampWhereASampleIsNotValid) {
  Estimate estimate(1);
  report(estimate.inbox(), 0, 10, 7ms);
  estimate.update();
  report(estimate.inbox(), 0, 20, 9ms, 0);
  EXPECT_EQ(estimate.update(), std::nullopt);
  EXPECT_EQ(estimate.x[0], 10);
  EXPECT_EQ(estimate.vz[0], 15);
  EXPECT_EQ(estimate.stamp[0], Time(7ms));
  EXPECT_EQ(estimate.valid[0], 1) << "its state is known, if old";
  EXPECT_EQ(estimate.fresh[0], 0);
}

TEST(Estimate, KeepsTheLastStateWhereAnyColumnIsNotANumber) {
  for (const float bad : {kNan, kInfinity, -kInfinity}) {
    for (int column = 0; column < 6; ++column) {
      Estimate estimate(1);
      report(estimate.inbox(), 0, 10, 7ms);
      estimate.update();
      report(estimate.inbox(), 0, 20, 9ms);
      const StateColumns in = estimate.inbox();
      const std::array<std::span<float>, 6> columns{in.x, in.y, in.z, in.vx, in.vy, in.vz};
      columns[static_cast<std::size_t>(column)][0] = bad;
      EXPECT_EQ(estimate.update(), RobotIndex{0}) << "column " << column;
      EXPECT_EQ(estimate.x[0], 10) << "column " << column;
      EXPECT_EQ(estimate.fresh[0], 0) << "column " << column;
      EXPECT_EQ(estimate.vz[0], 15) << "column " << column;
      EXPECT_EQ(estimate.stamp[0], Time(7ms)) << "column " << column;
    }
  }
}

TEST(Estimate, NamesTheFirstRobotThatClaimsANaN) {
  Estimate estimate(4);
  const StateColumns in = estimate.inbox();
  report(in, 0, kNan, 1ms, 0);  // says itself that it knows nothing
  report(in, 1, 1, 1ms);
  report(in, 2, kNan, 1ms);
  report(in, 3, kNan, 1ms);
  EXPECT_EQ(estimate.update(), RobotIndex{2});
  EXPECT_EQ(estimate.valid, (std::vector<std::uint8_t>{0, 1, 0, 0}));
}

TEST(Estimate, MayBeOfNobody) {
  Estimate estimate(0);
  EXPECT_TRUE(estimate.inbox().x.empty());
  EXPECT_EQ(estimate.update(), std::nullopt);
}

}  // namespace
}  // namespace mayfly
