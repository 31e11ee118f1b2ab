// The guard as a whole: what it makes of wishes, faults and operators.
#include "controller/guard/guard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/guard/field_trip.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;

std::vector<glm::vec3> row(std::size_t robots, float apart = 2.0F) {
  std::vector<glm::vec3> places;
  for (std::size_t i = 0; i < robots; ++i) {
    places.emplace_back(2.0F + apart * static_cast<float>(i), 10.0F, 10.0F);
  }
  return places;
}

void expect_no_breach(const Guard& guard) {
  const GuardReport report = guard.report();
  for (std::size_t i = 0; i < kInvariants; ++i) {
    EXPECT_EQ(report.invariants.breaches[i], 0U) << name_of(static_cast<Invariant>(i));
  }
}

TEST(Guard, FliesWhatIsWishedAsFarAsItIsSafe) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {0, 1, 0});
  trip.fly(3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(trip.robots.at[i].y, 12.0F);
    EXPECT_EQ(trip.severity(i), Severity::kNone);
    EXPECT_EQ(trip.guard->states()[i], RobotState::kFlying);
  }
  EXPECT_TRUE(trip.guard->held());
  EXPECT_EQ(trip.guard->reactions(), 0U);
  EXPECT_EQ(trip.robots.deadline, trip.now + 5 * kTick);
  expect_no_breach(*trip.guard);
}

TEST(Guard, RefusesAHalWithAnotherNumberOfRobots) {
  Robots robots(row(2));
  ASSERT_TRUE(robots.configure());
  const auto guard = Guard::create(guard_of(3), robots);
  ASSERT_FALSE(guard);
  EXPECT_THAT(guard.error().message, HasSubstr("2 robots"));
}

TEST(Guard, RefusesTimesThatAreNone) {
  for (Time GuardConfig::*time :
       {&GuardConfig::period, &GuardConfig::most_plan_age, &GuardConfig::command_life}) {
    GuardConfig config = guard_of(1);
    config.*time = Time{0};
    EXPECT_FALSE(check(config));
  }
  GuardConfig config = guard_of(1);
  EXPECT_TRUE(check(config));
  config.command_life = config.governor.command_life = config.period;
  EXPECT_FALSE(check(config)) << "robots would hold between two ticks";
  config = guard_of(1);
  config.governor.command_life += Time{1};
  EXPECT_FALSE(check(config)) << "the governor must know how long robots obey";
  config = guard_of(1);
  config.estimator.robots.clear();
  EXPECT_FALSE(check(config));
}

TEST(Guard, APlannerThatFallsSilentStopsEverybodyInTheTickAfterItsDeadline) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {0, 1, 0});
  trip.fly(2);
  trip.last_deadline = trip.now + 3 * kTick;
  trip.drift(0.03);
  EXPECT_EQ(trip.severity(0), Severity::kNone) << "it may be late";
  trip.drift(0.01);
  EXPECT_EQ(trip.severity(0), Severity::kHold);
  EXPECT_LT(trip.speed(0), 1.0F) << "braking has begun";
  trip.drift(0.5);
  EXPECT_THAT(trip.robots.kind, Each(CommandKind::kHold));
  trip.fly(0.5);
  EXPECT_EQ(trip.severity(0), Severity::kNone) << "a short stall ends by itself";
  EXPECT_GT(trip.speed(0), 0.5F);
  expect_no_breach(*trip.guard);
}

TEST(Guard, APlannerThatStallsForLongIsNotFlownAgainUnacknowledged) {
  FieldTrip trip(row(2));
  trip.wish = WishOf(2, {0, 1, 0});
  trip.fly(1);
  trip.drift(1.2);
  EXPECT_EQ(trip.severity(1), Severity::kHoldAll);
  trip.fly(1);
  EXPECT_EQ(trip.severity(1), Severity::kHoldAll);
  EXPECT_THAT(trip.robots.kind, Each(CommandKind::kHold));
  EXPECT_EQ(trip.guard->acknowledge(), Severity::kNone);
  trip.fly(1);
  EXPECT_GT(trip.speed(1), 0.5F);
  expect_no_breach(*trip.guard);
}

TEST(Guard, AnOperatorsHoldStopsAllAndGoesPastEveryWish) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {1, 1, 0});
  trip.fly(1);
  trip.guard->tell(Symptom::kOperatorHold);
  const float before = trip.speed(2);
  trip.tick();
  EXPECT_LT(trip.speed(2), before) << "in the same tick";
  trip.fly(1);
  EXPECT_THAT(trip.robots.kind, Each(CommandKind::kHold));
  EXPECT_EQ(trip.guard->states()[0], RobotState::kHolding);
  EXPECT_EQ(trip.guard->acknowledge(), Severity::kNone);
  trip.fly(1);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kFlying);
  expect_no_breach(*trip.guard);
}

TEST(Guard, AnEmergencyStopCutsInTheSameTick) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {1, 1, 0});
  trip.fly(1);
  trip.guard->tell(Symptom::kEmergencyStop);
  trip.tick();
  EXPECT_THAT(trip.robots.kind, Each(CommandKind::kStop));
  trip.fly(1);
  EXPECT_THAT(trip.robots.kind, Each(CommandKind::kStop)) << "latched";
}

TEST(Guard, ARobotWithoutPosesHoldsAndTheOthersFlyOn) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {0, 1, 0});
  trip.fly(1);
  trip.robots.mute[1] = 1;
  trip.fly(0.09);
  EXPECT_EQ(trip.severity(1), Severity::kNone) << "not yet";
  trip.fly(0.02);
  EXPECT_EQ(trip.severity(1), Severity::kHold);
  trip.fly(0.2);
  EXPECT_LT(trip.speed(1), 0.5F);
  EXPECT_GT(trip.speed(0), 0.9F);
  trip.robots.mute[1] = 0;
  trip.fly(1);
  EXPECT_EQ(trip.severity(1), Severity::kNone);
}

TEST(Guard, ALinkThatIsDownHoldsItsRobotsThenAll) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {0, 1, 0});
  trip.fly(1);
  trip.robots.read_result = {HalFault::kLinkDown, kEveryRobot, "first", "unplugged"};
  trip.fly(0.05);
  EXPECT_EQ(trip.severity(0), Severity::kHold);
  EXPECT_EQ(trip.severity(2), Severity::kNone) << "another link";
  trip.fly(0.1);
  EXPECT_EQ(trip.severity(2), Severity::kHoldAll);
}

TEST(Guard, RobotsThatGiveUpForGoodHoldAllAtOnce) {
  FieldTrip trip(row(3));
  trip.wish = WishOf(3, {0, 1, 0});
  trip.fly(1);
  EXPECT_EQ(trip.severity(2), Severity::kNone);
  trip.robots.read_result = {HalFault::kGivenUp, kEveryRobot, "first", "no device"};
  trip.fly(0.02);
  EXPECT_EQ(trip.severity(2), Severity::kHoldAll) << "whatever its link";
  EXPECT_TRUE(trip.guard->everybody().has(Symptom::kSimulationFailed));
}

TEST(Guard, AnEmptyBatteryLandsItsRobotInsideTheGuarantee) {
  FieldTrip trip({{5, 10, 3}, {5, 10, 1.5F}, {12, 10, 3}});
  trip.robots.telemetry[0].battery = 0.25F;
  trip.fly(0.5);
  EXPECT_EQ(trip.severity(0), Severity::kNone);
  trip.robots.telemetry[0].battery = 0.14F;
  trip.fly(2);
  EXPECT_EQ(trip.severity(0), Severity::kLand);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kLanding);
  EXPECT_LT(trip.robots.at[0].z, 3.0F);
  EXPECT_EQ(trip.severity(2), Severity::kNone) << "it alone";
  trip.fly(8);
  EXPECT_GT(trip.robots.at[0].z, 1.7F) << "not onto the one below";
  EXPECT_NE(trip.robots.kind[0], CommandKind::kLand);
  trip.wish.vx[1] = 1.0F;
  trip.fly(8);
  EXPECT_LT(trip.robots.at[0].z, 0.5F);
  EXPECT_EQ(trip.robots.kind[0], CommandKind::kLand) << "the rest is its firmware's";
  expect_no_breach(*trip.guard);
}

TEST(Guard, OneThatDriftsIsToldAndHoldsItsPlaceAndLandsBesideNobody) {
  FieldTrip trip({{5, 10, 3}, {5, 10.6F, 3}});
  trip.fly(0.5);
  trip.robots.wind[0] = {0, 0.5F, 0};
  trip.fly(0.3);
  EXPECT_EQ(trip.severity(0), Severity::kHold);
  EXPECT_EQ(trip.severity(1), Severity::kNone);
  float farthest = 0.0F;
  for (int n = 0; n < 1000; ++n) {
    trip.tick();
    if (trip.robots.kind[0] == CommandKind::kVelocity) {
      farthest = std::max(farthest, std::hypot(trip.robots.at[0].x - 5.0F, trip.robots.at[0].y - 10.0F));
    }
  }
  EXPECT_EQ(trip.severity(0), Severity::kLand);
  EXPECT_LT(trip.robots.at[0].z, 0.5F) << "it is brought down";
  EXPECT_LT(farthest, 0.25F) << "against the wind, which would have carried it metres away";
  EXPECT_EQ(trip.robots.kind[0], CommandKind::kLand);
}

// Wind that is within what a tube allows is not told, and followed.
TEST(Guard, OneThatDriftsSlowlyFliesOn) {
  FieldTrip trip({{5, 10, 3}});
  trip.fly(0.5);
  trip.robots.wind[0] = {0, 0.05F, 0};
  trip.fly(3);
  EXPECT_EQ(trip.severity(0), Severity::kNone);
}

TEST(Guard, OneThatWasNeverHeardIsToldToHoldAndNothingEscalates) {
  FieldTrip trip(row(2));
  trip.robots.mute[0] = 1;
  trip.wish = WishOf(2, {0, 1, 0});
  trip.fly(5);
  EXPECT_EQ(trip.severity(0), Severity::kNone);
  EXPECT_EQ(trip.robots.kind[0], CommandKind::kHold);
  EXPECT_GT(trip.speed(1), 0.9F);
}

TEST(Guard, TheAbsentAreToldToHoldAndMindedByNobody) {
  FieldTrip trip(row(2, 1.0F));
  const std::vector<std::uint8_t> present{1, 0};
  trip.guard->set_present(present);
  trip.wish = WishOf(2, {1, 0, 0});
  trip.fly(2);
  EXPECT_EQ(trip.robots.kind[1], CommandKind::kHold);
  EXPECT_GT(trip.robots.at[0].x, 3.5F) << "through where the other is not";
  EXPECT_EQ(trip.guard->reactions(), 0U);
}

TEST(Guard, OfTheUngovernedOnlyWhatConcernsEverybodyCounts) {
  GuardConfig config = guard_of(2);
  config.governor.groups[0].enabled = false;
  FieldTrip trip(row(2), config);
  trip.wish = WishOf(2, {0, 1, 0});
  trip.fly(1);
  trip.robots.mute[0] = 1;
  trip.fly(3);
  EXPECT_EQ(trip.severity(0), Severity::kNone);
  trip.guard->tell(Symptom::kOperatorHold);
  trip.fly(1);
  EXPECT_EQ(trip.severity(1), Severity::kHoldAll);
}

TEST(Guard, AnIncidentSealsTheBlackBoxWithWhatWentBefore) {
  FieldTrip trip(row(2));
  trip.wish = WishOf(2, {0, 1, 0});
  trip.fly(2);
  trip.guard->tell(Symptom::kOperatorHold);
  trip.tick();
  EXPECT_EQ(trip.guard->black_box().sealed(), nullptr) << "that is how a flight ends";
  trip.guard->tell(Symptom::kSimulationFailed);
  trip.tick();
  const BlackBoxTape* tape = trip.guard->black_box().sealed();
  ASSERT_NE(tape, nullptr);
  EXPECT_EQ(tape->size(), 100U);
  EXPECT_EQ(tape->frame(99).time, trip.now);
  EXPECT_TRUE(tape->frame(99).everybody.has(Symptom::kSimulationFailed));
  EXPECT_EQ(tape->rows(99)[0].severity, Severity::kHoldAll);
  EXPECT_EQ(tape->rows(50)[0].severity, Severity::kNone);
}

TEST(Guard, AfterANewActivationNumbersBeginAnew) {
  FieldTrip trip(row(2));
  trip.fly(1);
  ASSERT_TRUE(trip.robots.deactivate(trip.now));
  ASSERT_TRUE(trip.robots.activate(trip.now));
  trip.guard->restart();
  trip.sequence = 0;
  trip.tick();
  EXPECT_EQ(trip.robots.sequence, 1U);
  EXPECT_EQ(trip.severity(0), Severity::kNone);
  expect_no_breach(*trip.guard);
}

TEST(Guard, ATickAllocatesNothing) {
  FieldTrip trip(row(9));
  trip.wish = WishOf(9, {1, 1, 0});
  trip.fly(1);
  const std::uint64_t before = allocation_count();
  trip.robots.mute[3] = 1;
  trip.fly(3);
  trip.guard->tell(Symptom::kSimulationFailed);
  trip.fly(1);
  trip.guard->acknowledge();
  trip.drift(2);
  EXPECT_EQ(allocation_count(), before);
}

// Whatever a planner wishes: nobody touches, and nothing that is sent breaks an invariant.
TEST(Guard, KeepsEveryInvariantAgainstHostileWishes) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> any(-5.0F, 5.0F);
  FieldTrip trip(row(8, 0.8F));
  for (int tick = 0; tick < 3000; ++tick) {
    for (std::size_t i = 0; i < 8; ++i) {
      const auto how = random() % 64;
      const glm::vec3 to_centre = glm::vec3(5, 10, 10) - trip.robots.at[i];
      const glm::vec3 v = how < 56 ? 10.0F * to_centre : glm::vec3(any(random), any(random), any(random));
      trip.wish.kind[i] = how == 63 ? static_cast<CommandKind>(random() % 8) : CommandKind::kVelocity;
      trip.wish.kind[i] = trip.wish.kind[i] == CommandKind::kStop || trip.wish.kind[i] == CommandKind::kLand
                              ? CommandKind::kHold
                              : trip.wish.kind[i];
      trip.wish.vx[i] = how == 62 ? std::numeric_limits<float>::quiet_NaN() : v.x;
      trip.wish.vy[i] = v.y;
      trip.wish.vz[i] = v.z;
    }
    if (random() % 32 == 0) {
      trip.sequence -= std::min<std::uint64_t>(trip.sequence, random() % 3);  // replayed
    }
    trip.tick();
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = i + 1; j < 8; ++j) {
        ASSERT_GE(glm::distance(trip.robots.at[i], trip.robots.at[j]), 0.2F)
            << i << ' ' << j << " at " << tick;
      }
    }
  }
  expect_no_breach(*trip.guard);
  EXPECT_GT(trip.guard->report().governor.interventions, 1000U);
}

}  // namespace
}  // namespace mayfly::test
