// To a flight, a guard is one more HAL.
#include "controller/guard/guarded_hal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/guard/field_trip.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;

struct Flight {
  Flight() : robots({{2, 5, 5}, {5, 5, 5}}), hal(guard_of(2), robots) {
    EXPECT_TRUE(hal.configure());
    EXPECT_TRUE(hal.activate(now));
  }
  void tick() {
    now += kTick;
    hal.read(now, {x, y, z, vx, vy, vz, stamp, valid});
    hal.write(now, wish.columns(now + 3 * kTick, ++sequence));
  }
  void fly(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      tick();
    }
  }
  Robots robots;
  GuardedHal hal;
  WishOf wish{2, {0, 1, 0}};
  std::vector<float> x = std::vector<float>(2), y = x, z = x, vx = x, vy = x, vz = x;
  std::vector<Time> stamp = std::vector<Time>(2);
  std::vector<std::uint8_t> valid = std::vector<std::uint8_t>(2);
  Time now{std::chrono::seconds(1)};
  std::uint64_t sequence = 0;
};

TEST(GuardedHal, ReadsWhatTheGuardKnowsAndWritesWhatItAllows) {
  Flight flight;
  flight.wish = WishOf(2, {0, 50, 0});
  flight.fly(200);
  EXPECT_EQ(flight.valid[0], 1);
  EXPECT_EQ(flight.y[0], flight.robots.at[0].y);
  EXPECT_EQ(flight.stamp[0], flight.now);
  EXPECT_EQ(flight.hal.written().vy[0], flight.robots.velocity[0].y);
  EXPECT_LE(glm::length(flight.robots.velocity[0]), 2.0F * 1.00001F);
  flight.robots.mute[1] = 1;
  flight.tick();
  EXPECT_EQ(flight.valid[1], 0) << "not fresh";
  EXPECT_GT(flight.hal.report().governor.interventions, 0U);
}

TEST(GuardedHal, AWishWithoutANumberBrakesThatRobot) {
  Flight flight;
  flight.fly(100);
  flight.wish.vx[1] = std::numeric_limits<float>::quiet_NaN();
  flight.fly(60);
  EXPECT_EQ(glm::length(flight.robots.velocity[1]), 0.0F);
  EXPECT_GT(glm::length(flight.robots.velocity[0]), 0.9F);
  EXPECT_GT(flight.hal.report().wishes.not_finite, 0U);
}

TEST(GuardedHal, ATickWhoseWishWasRefusedOnItsWayHasACommandAllTheSame) {
  Flight flight;
  flight.fly(100);
  flight.sequence = 3;
  for (int i = 0; i < 50; ++i) {
    flight.now += kTick;
    flight.hal.read(flight.now, {flight.x, flight.y, flight.z, flight.vx, flight.vy, flight.vz, flight.stamp,
                                 flight.valid});
    EXPECT_EQ(flight.hal.write(flight.now, flight.wish.columns(flight.now + kTick, 2)).fault,
              HalFault::kOutOfSequence);
  }
  EXPECT_EQ(glm::length(flight.robots.velocity[0]), 0.0F) << "nobody wishes anything that is new";
  EXPECT_GE(flight.robots.sequence, 149U);
  EXPECT_EQ(flight.hal.severity(), Severity::kHold);
}

TEST(GuardedHal, AReplayedWishIsToldInTheTickThatItComesIn) {
  Flight flight;
  flight.fly(10);
  const std::uint64_t before = flight.hal.reactions();
  flight.now += kTick;
  flight.hal.read(flight.now, {flight.x, flight.y, flight.z, flight.vx, flight.vy, flight.vz, flight.stamp,
                               flight.valid});
  EXPECT_FALSE(flight.hal.write(flight.now, flight.wish.columns(flight.now + kTick, 3)).ok());
  EXPECT_TRUE(flight.hal.write(flight.now, flight.wish.columns(flight.now + kTick, ++flight.sequence)).ok());
  ASSERT_EQ(flight.hal.reactions(), before + 1);
  EXPECT_EQ(flight.hal.events().back().symptom, Symptom::kCommandRefused);
  EXPECT_EQ(flight.hal.report().wishes.refused, 1U);
}

TEST(GuardedHal, StopsWhenAskedOnceAndCutsWhenAskedTwice) {
  Flight flight;
  flight.fly(100);
  flight.hal.ask_to_stop(1);
  flight.fly(60);
  EXPECT_THAT(flight.robots.kind, Each(CommandKind::kHold));
  EXPECT_EQ(flight.hal.severity(), Severity::kHoldAll);
  flight.hal.ask_to_stop(2);
  flight.tick();
  EXPECT_THAT(flight.robots.kind, Each(CommandKind::kStop));
  flight.hal.ask_to_stop(0);
  flight.tick();
  EXPECT_EQ(flight.hal.severity(), Severity::kCut) << "latched";
  flight.hal.acknowledge();
  flight.tick();
  EXPECT_EQ(flight.hal.severity(), Severity::kNone);
  EXPECT_EQ(flight.hal.report().worst, Severity::kCut);
  EXPECT_EQ(flight.hal.events().size(), flight.hal.reactions());
}

TEST(GuardedHal, TellsWhyItCannotBeConfigured) {
  Robots robots({{1, 1, 1}});
  GuardedHal two(guard_of(2), robots);
  EXPECT_FALSE(two.configure());
  GuardConfig bad = guard_of(1);
  bad.governor.groups[0].limits.speed = -1.0F;
  GuardedHal slow(bad, robots);
  EXPECT_FALSE(slow.configure());
  GuardedHal good(guard_of(1), robots);
  EXPECT_TRUE(good.configure()) << "though the robots were configured before";
}

}  // namespace
}  // namespace mayfly::test
