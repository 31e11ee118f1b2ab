// Whatever comes in, what is known is a number, and nothing is allocated.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

constexpr std::size_t kRobots = 6;
constexpr std::size_t kSources = 3;

EstimatorConfig three_sources() {
  EstimatorConfig config = config_of(kRobots, 0.0F);
  config.sources.resize(kSources);
  config.sources[1].pose_noise = 0.02F;
  config.sources[1].takes_velocity = false;
  config.sources[2].takes_pose = false;
  config.robots[3].speed = std::numeric_limits<float>::infinity();
  return config;
}

class Garbage {
 public:
  explicit Garbage(unsigned seed) : random_(seed) {}

  float number() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 10> kOdd = {
        0.0F,  -0.0F,  1e-45F,    1e6F,       -1e6F,
        3e38F, -3e38F, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
    switch (pick(4)) {
      case 0:
        return kOdd[pick(kOdd.size())];
      case 1: {
        const auto bits = static_cast<std::uint32_t>(random_());
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof value);
        return value;
      }
      case 2:
        return static_cast<float>(pick(2'000'000)) - 1e6F;
      default:
        return 0.001F * static_cast<float>(pick(4000));
    }
  }
  Time time(Time now) {
    switch (pick(6)) {
      case 0:
        return Time::min();
      case 1:
        return Time::max();
      case 2:
        return Time(static_cast<std::int64_t>(random_()));
      case 3:
        return now + Time(static_cast<int>(pick(20)));
      default:
        return now - Time(static_cast<std::int64_t>(pick(60'000'000)));
    }
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(pick(4) * 85); }
  std::size_t pick(std::size_t below) { return static_cast<std::size_t>(random_() % below); }

 private:
  std::mt19937_64 random_;
};

void fill(const StateColumns& in, Garbage& garbage, Time now) {
  for (std::size_t r = 0; r < kRobots; ++r) {
    in.x[r] = garbage.number(), in.y[r] = garbage.number(), in.z[r] = garbage.number();
    in.vx[r] = garbage.number(), in.vy[r] = garbage.number(), in.vz[r] = garbage.number();
    in.stamp[r] = garbage.time(now);
    in.valid[r] = garbage.byte();
  }
}

void expect_numbers(const EstimateColumns& out, std::size_t& known) {
  for (std::size_t r = 0; r < kRobots; ++r) {
    if (out.known[r] != 0) {
      ++known;
      ASSERT_TRUE(std::isfinite(out.x[r]) && std::isfinite(out.y[r]) && std::isfinite(out.z[r]) &&
                  std::isfinite(out.vx[r]) && std::isfinite(out.vy[r]) && std::isfinite(out.vz[r]))
          << "robot " << r;
    }
  }
}

class Hostile : public ::testing::TestWithParam<unsigned> {};

TEST_P(Hostile, WhatIsKnownIsANumber) {
  Garbage garbage(GetParam());
  auto made = Estimator::create(three_sources());
  Estimator& estimator = made.value();
  std::array<CommandKind, kRobots> kind{};
  std::array<float, kRobots> vx{}, vy{}, vz{};
  Time now{0};
  std::size_t known = 0;
  std::uint64_t allocations = 0;
  for (std::uint64_t tick = 1; tick <= 3000; ++tick) {
    for (std::size_t s = 0; s < kSources; ++s) {
      fill(estimator.inbox(s), garbage, now);
    }
    const std::uint64_t before = allocation_count();
    estimator.update(now);
    allocations += allocation_count() - before;
    ASSERT_NO_FATAL_FAILURE(expect_numbers(estimator.estimate(), known));
    for (std::size_t r = 0; r < kRobots; ++r) {
      kind[r] = static_cast<CommandKind>(garbage.pick(6));
      vx[r] = garbage.number(), vy[r] = garbage.number(), vz[r] = garbage.number();
    }
    estimator.sent(now, {kind, vx, vy, vz, garbage.time(now), tick});
    now += Time(static_cast<std::int64_t>(garbage.pick(30'000'000)));
  }
  EXPECT_EQ(allocations, 0U);
  EXPECT_GT(known, 1000U) << "garbage in which nothing is ever taken tests nothing";
}
INSTANTIATE_TEST_SUITE_P(Seeds, Hostile, ::testing::Range(0U, 20U));

// Every gate opens and closes, names are exchanged and given back: still nothing is allocated.
TEST(Allocation, NoneInAnyUpdate) {
  Rig rig(config_of(4, 0.001F));
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 0.001);
  const std::uint64_t before = allocation_count();
  for (int tick = 0; tick < 400; ++tick) {
    const bool swapped = tick > 100 && tick < 150;
    for (std::size_t r = 0; r < 4; ++r) {
      const double leap = tick > 200 && tick < 210 && r == 3 ? 2.0 : 0.0;
      const Vec place{static_cast<double>(r), 5.0 + leap + normal(random), 1.0 + normal(random)};
      const std::size_t column = swapped && r < 2 ? 1 - r : r;
      rig.put_at(column, place, {}, rig.now - (tick % 3 == 0 ? 2 * kPeriod + kPeriod / 2 : Time{0}));
    }
    rig.tick();
  }
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(rig.estimator.counters().id_swaps, 2U);
  EXPECT_GE(rig.estimator.counters().started_anew, 1U);
  EXPECT_GT(rig.count(SampleFate::kTakenLate), 50U);
}

}  // namespace
}  // namespace mayfly::estimator_test
