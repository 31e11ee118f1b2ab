// Each fault fires where it is asked for, and only there; and all of them are the same in every run.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/unit/sim_hal/flight.hpp"

namespace mayfly::sim_hal {
namespace {

SimHalConfig with(const Faults& faults, std::size_t robots = 100) {
  SimHalConfig config = row_of(robots, Plant::kIdeal);
  config.faults = faults;
  config.seed = 11;
  return config;
}

TEST(Faults, NoneByDefault) {
  Flight flight(with({}));
  for (int tick = 0; tick < 100; ++tick) {
    flight.tick();
    const PoseView truth = flight.hal.truth();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      ASSERT_EQ(flight.states.valid[robot], 1);
      ASSERT_EQ(flight.states.x[robot], truth.columns[0][robot]);
      ASSERT_EQ(flight.states.vx[robot], truth.columns[3][robot]);
      ASSERT_EQ(flight.states.stamp[robot], truth.stamp);
    }
  }
  const FaultCounters& counters = flight.hal.fault_counters();
  EXPECT_EQ(counters.noisy + counters.delayed + counters.withheld + counters.dropped + counters.frozen +
                counters.nans,
            0U);
}

TEST(Faults, NoiseIsGaussianAndIndependent) {
  Faults faults;
  faults.pose_noise = 0.05F;
  Flight flight(with(faults));
  double sum = 0.0, squares = 0.0, cross = 0.0, fourth = 0.0;
  int count = 0;
  for (int tick = 0; tick < 200; ++tick) {
    flight.tick();
    const PoseView truth = flight.hal.truth();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      const double x = static_cast<double>(flight.states.x[robot] - truth.columns[0][robot]) / 0.05;
      const double y = static_cast<double>(flight.states.y[robot] - truth.columns[1][robot]) / 0.05;
      const double z = static_cast<double>(flight.states.z[robot] - truth.columns[2][robot]) / 0.05;
      for (const double e : {x, y, z}) {
        sum += e;
        squares += e * e;
        fourth += e * e * e * e;
        ++count;
      }
      cross += x * y + y * z + z * x;
    }
  }
  // 60 000 samples: five standard errors each.
  const double n = count;
  EXPECT_NEAR(sum / n, 0.0, 5.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0, 5.0 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3.0, 5.0 * std::sqrt(96.0 / n));
  EXPECT_NEAR(cross / n, 0.0, 5.0 / std::sqrt(n));
  EXPECT_EQ(flight.hal.fault_counters().noisy, 20000U);
}

TEST(Faults, ADelayedPoseIsAnOldOneAndSaysSo) {
  Faults faults;
  faults.delay = 0.05F;
  Flight flight(with(faults, 1));
  for (int tick = 0; tick < 5; ++tick) {
    flight.tick();
    EXPECT_EQ(flight.states.valid[0], 0) << tick;  // nothing has arrived yet
  }
  EXPECT_EQ(flight.hal.fault_counters().withheld, 5U);
  std::vector<float> past{flight.hal.truth().columns[0][0]};
  for (int tick = 0; tick < 100; ++tick) {
    const Time now = flight.now;
    flight.tick();
    past.push_back(flight.hal.truth().columns[0][0]);
    ASSERT_EQ(flight.states.valid[0], 1);
    ASSERT_EQ(flight.states.stamp[0], now - std::chrono::milliseconds(50));
    if (past.size() > 5) {
      ASSERT_EQ(flight.states.x[0], past[past.size() - 6]);
    }
  }
  EXPECT_EQ(flight.hal.fault_counters().delayed, 100U);
}

TEST(Faults, WhatWasMeasuredBeforeAnActivationIsNotToldAfterIt) {
  Faults faults;
  faults.delay = 0.05F;
  Flight flight(with(faults, 1));
  flight.ticks(20);
  ASSERT_EQ(flight.states.valid[0], 1);
  ASSERT_TRUE(flight.hal.deactivate(flight.now).has_value());
  ASSERT_TRUE(flight.hal.activate(flight.now).has_value());
  flight.sequence = 0;
  flight.tick();
  EXPECT_EQ(flight.states.valid[0], 0);
}

TEST(Faults, ADroppedSampleLeavesTheLastValue) {
  Faults faults;
  faults.dropout = 0.2F;
  Flight flight(with(faults));
  int dropped = 0;
  for (int tick = 0; tick < 100; ++tick) {
    const contract::States before = flight.states;
    flight.tick();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      if (flight.states.valid[robot] == 0) {
        ++dropped;
        ASSERT_EQ(flight.states.x[robot], before.x[robot]);
        ASSERT_EQ(flight.states.stamp[robot], before.stamp[robot]);
      }
    }
  }
  EXPECT_NEAR(dropped, 2000, 5 * 40);  // five standard deviations
  EXPECT_EQ(flight.hal.fault_counters().dropped, static_cast<std::uint64_t>(dropped));
}

TEST(Faults, AFrozenRobotKeepsItsValuesWhileItsStampsGoOn) {
  Faults faults;
  faults.freeze = 0.2F;
  faults.freeze_time = 0.5F;
  Flight flight(with(faults));
  int frozen = 0;
  int longest = 0;
  std::vector<int> run(100);
  flight.ticks(2);
  const std::uint64_t before_counting = flight.hal.fault_counters().frozen;
  for (int tick = 0; tick < 1000; ++tick) {
    const contract::States before = flight.states;
    flight.tick();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      ASSERT_GT(flight.states.stamp[robot], before.stamp[robot]);
      ASSERT_EQ(flight.states.valid[robot], 1);
      const bool stays = flight.states.x[robot] == before.x[robot];
      frozen += stays ? 1 : 0;
      run[robot] = stays ? run[robot] + 1 : 0;
      longest = std::max(longest, run[robot]);
    }
  }
  // 100 robots · 10 s · 0.2 a second · 50 ticks, less the overlaps.
  EXPECT_NEAR(frozen, 10000, 1500);
  EXPECT_GE(longest, 49);
  EXPECT_EQ(flight.hal.fault_counters().frozen - before_counting, static_cast<std::uint64_t>(frozen));
}

TEST(Faults, ANanClaimsToBeValid) {
  Faults faults;
  faults.nan = 0.1F;
  Flight flight(with(faults));
  int nans = 0;
  for (int tick = 0; tick < 100; ++tick) {
    flight.tick();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      ASSERT_EQ(flight.states.valid[robot], 1);
      nans += std::isnan(flight.states.x[robot]) && std::isnan(flight.states.vz[robot]) ? 1 : 0;
    }
  }
  EXPECT_NEAR(nans, 1000, 5 * 30);
  EXPECT_EQ(flight.hal.fault_counters().nans, static_cast<std::uint64_t>(nans));
  EXPECT_TRUE(std::isfinite(flight.hal.truth().columns[0][0]));  // the robot itself is well
}

// Reading twice within a step is reading the same sample; reading in between changes nothing of what is read
// later.
TEST(Faults, DoNotDependOnHowOftenSomebodyReads) {
  Faults faults{0.05F, 0.0F, 0.2F, 0.3F, 0.4F, 0.1F};
  faults.freeze = 0.0F;  // a frozen robot shows the last value that was read, so that one does
  Flight once(with(faults));
  Flight often(with(faults));
  for (int tick = 0; tick < 100; ++tick) {
    once.tick();
    for (int more = 0; more < tick % 3; ++more) {
      often.hal.read(often.now - Time(1), often.states.columns());
    }
    often.tick();
    for (std::size_t robot = 0; robot < 100; ++robot) {
      ASSERT_EQ(once.states.valid[robot], often.states.valid[robot]);
      if (once.states.valid[robot] != 0) {
        ASSERT_EQ(std::memcmp(&once.states.x[robot], &often.states.x[robot], sizeof(float)), 0);
      }
    }
  }
}

TEST(Faults, FollowFromTheSeed) {
  Faults faults{0.05F, 0.02F, 0.2F, 0.3F, 0.4F, 0.1F};
  const auto last_states = [&faults](std::uint64_t seed) {
    SimHalConfig config = with(faults);
    config.seed = seed;
    Flight flight(config);
    flight.ticks(200);
    return flight.states;
  };
  const contract::States a = last_states(3);
  const contract::States b = last_states(3);
  const contract::States c = last_states(std::uint64_t{3} + (std::uint64_t{1} << 40U));
  EXPECT_EQ(std::memcmp(a.x.data(), b.x.data(), a.x.size() * sizeof(float)), 0);
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_NE(std::memcmp(a.x.data(), c.x.data(), a.x.size() * sizeof(float)), 0);
}

}  // namespace
}  // namespace mayfly::sim_hal
