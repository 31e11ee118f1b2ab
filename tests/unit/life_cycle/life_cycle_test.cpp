// What is seen drives a life, what is wished is let through or not.
#include "controller/life_cycle/life_cycle.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/reference/allocation_count.hpp"

namespace mayfly {
namespace {

constexpr Time kNow = std::chrono::seconds(100);
constexpr Time kSecond = std::chrono::seconds(1);

// A HAL that tells nothing beside poses.
Observation plain(Time now = kNow) {
  Observation seen;
  seen.now = seen.sampled = now;
  seen.telemetry.heard = Time::min();
  seen.known = true;
  return seen;
}

// A robot on the ground that is well.
Observation on_ground(Time now = kNow) {
  Observation seen = plain(now);
  seen.telemetry = {now, 0.9F, 1.0F, false};
  return seen;
}

Observation in_air(Time now = kNow) {
  Observation seen = on_ground(now);
  seen.telemetry.airborne = true;
  return seen;
}

// One robot, taken as far as it is told.
LifeCycles flying() {
  LifeCycles lives({.robots = 1});
  lives.observe(0, in_air());
  return lives;
}

TEST(FoundInTheAir, FliesFromTheFirstTick) {
  LifeCycles lives({.robots = 2});
  lives.observe(0, plain());
  lives.observe(1, in_air());
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
  EXPECT_EQ(lives.state(1), RobotState::kFlying);
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kVelocity);
  EXPECT_EQ(lives.counters().refused_commands, 0U);
  EXPECT_EQ(lives.counters().refused, 0U);
}

TEST(FoundInTheAir, ButNotKnownItIsHeld) {
  LifeCycles lives({.robots = 1});
  Observation seen = in_air();
  seen.known = false;
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kConnected);
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kHold);
  EXPECT_EQ(lives.counters().refused_commands, 1U);
}

TEST(OnTheGround, WaitsForItsOperator) {
  LifeCycles lives({.robots = 1});
  for (int i = 0; i < 5; ++i) {
    lives.observe(0, on_ground());
    EXPECT_EQ(lives.state(0), RobotState::kChecked);
  }
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kNone);
  EXPECT_EQ(lives.admit(0, CommandKind::kTakeOff), CommandKind::kNone) << "nobody armed it";
  EXPECT_TRUE(lives.request(0, RobotEvent::kArm));
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kNone);
  EXPECT_EQ(lives.counters().refused_commands, 3U);
}

TEST(OnTheGround, AWholeLife) {
  LifeCycles lives({.robots = 1});
  lives.observe(0, on_ground());
  lives.request(0, RobotEvent::kArm);
  EXPECT_EQ(lives.admit(0, CommandKind::kTakeOff), CommandKind::kTakeOff);
  EXPECT_EQ(lives.state(0), RobotState::kTakingOff);
  lives.observe(0, on_ground());
  EXPECT_EQ(lives.state(0), RobotState::kTakingOff) << "not up yet, and not landed";
  EXPECT_EQ(lives.admit(0, CommandKind::kHold), CommandKind::kTakeOff) << "no planner holds it up";
  lives.observe(0, in_air());
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
  EXPECT_EQ(lives.admit(0, CommandKind::kHold), CommandKind::kHold);
  EXPECT_EQ(lives.state(0), RobotState::kFlying) << "a planner that holds for a tick";
  EXPECT_EQ(lives.admit(0, CommandKind::kLand), CommandKind::kLand);
  EXPECT_EQ(lives.state(0), RobotState::kLanding);
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kLand);
  EXPECT_EQ(lives.admit(0, CommandKind::kNone), CommandKind::kLand);
  lives.observe(0, on_ground());
  EXPECT_EQ(lives.state(0), RobotState::kOff);
  EXPECT_EQ(lives.admit(0, CommandKind::kHold), CommandKind::kStop);
  lives.observe(0, on_ground());
  EXPECT_EQ(lives.state(0), RobotState::kOff) << "until an operator clears it";
  lives.request(0, RobotEvent::kClear);
  lives.observe(0, on_ground());
  EXPECT_EQ(lives.state(0), RobotState::kChecked);
}

TEST(OnTheGround, AfterAFlightWithoutAnOrderItIsOff) {
  LifeCycles lives = flying();
  lives.observe(0, on_ground());
  EXPECT_EQ(lives.state(0), RobotState::kOff);
}

class Checks : public ::testing::Test {
 protected:
  RobotState after(const Observation& seen) {
    lives_.observe(0, seen);
    return lives_.state(0);
  }
  LifeCycles lives_{LifeCycleConfig{.robots = 1, .least_battery = 0.2F}};
};

TEST_F(Checks, NeedAnEstimate) {
  Observation seen = on_ground();
  seen.known = false;
  EXPECT_EQ(after(seen), RobotState::kConnected);
  EXPECT_EQ(after(on_ground()), RobotState::kChecked);
  EXPECT_EQ(after(seen), RobotState::kConnected);
}

TEST_F(Checks, NeedABatteryWhereThereIsOne) {
  Observation seen = on_ground();
  seen.telemetry.battery = 0.199F;
  EXPECT_EQ(after(seen), RobotState::kConnected);
  seen.telemetry.battery = 0.2F;
  EXPECT_EQ(after(seen), RobotState::kChecked);
  seen.telemetry.battery = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(after(seen), RobotState::kChecked);
}

TEST_F(Checks, HearWhoeverSpeaksAgainstIt) {
  Observation seen = on_ground();
  seen.fit = false;
  EXPECT_EQ(after(seen), RobotState::kConnected);
  EXPECT_EQ(after(on_ground()), RobotState::kChecked);
  ASSERT_TRUE(lives_.request(0, RobotEvent::kArm));
  EXPECT_EQ(after(seen), RobotState::kConnected) << "disarmed";
}

TEST_F(Checks, ARobotInTheAirIsNotDisarmed) {
  EXPECT_EQ(after(in_air()), RobotState::kFlying);
  Observation seen = in_air();
  seen.fit = seen.known = false;
  seen.telemetry.battery = 0.0F;
  EXPECT_EQ(after(seen), RobotState::kFlying);
}

TEST(Lost, AfterTheLimitAndNotBefore) {
  LifeCycles lives = flying();
  Observation seen = in_air();
  seen.now = kNow + kSecond;
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
  seen.now += Time(1);
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kFault);
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kHold);
}

TEST(Lost, StaysAFaultWhenItIsHeardAgainAndClearsByAnOperator) {
  LifeCycles lives = flying();
  Observation seen = in_air();
  seen.now = kNow + 2 * kSecond;
  lives.observe(0, seen);
  lives.observe(0, in_air(kNow + 3 * kSecond));
  EXPECT_EQ(lives.state(0), RobotState::kFault);
  EXPECT_FALSE(lives.request(0, RobotEvent::kResume));
  EXPECT_TRUE(lives.request(0, RobotEvent::kClear));
  lives.observe(0, in_air(kNow + 3 * kSecond));
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
}

TEST(Lost, OnTheGroundItIsUnknownAgain) {
  LifeCycles lives({.robots = 1});
  lives.observe(0, on_ground());
  Observation seen = on_ground();
  seen.now = kNow + 2 * kSecond;
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kUnknown);
}

TEST(Lost, ASampleIsASignOfLifeToo) {
  LifeCycles lives = flying();
  Observation seen = in_air();
  seen.now = seen.sampled = kNow + 2 * kSecond;
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
}

TEST(Lost, WildTimesAreNoSignOfLife) {
  LifeCycles lives({.robots = 1});
  Observation seen = plain();
  seen.sampled = Time::min();
  lives.observe(0, seen);
  seen.telemetry.heard = Time::min() + Time(1);
  lives.observe(0, seen);
  EXPECT_EQ(lives.state(0), RobotState::kUnknown);
}

TEST(Fault, OnTheGroundMotorsStop) {
  LifeCycles lives({.robots = 1});
  lives.observe(0, on_ground());
  EXPECT_TRUE(lives.request(0, RobotEvent::kFail));
  EXPECT_EQ(lives.admit(0, CommandKind::kNone), CommandKind::kStop);
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kStop);
  EXPECT_EQ(lives.admit(0, CommandKind::kLand), CommandKind::kLand);
}

TEST(Operator, HoldsResumesReturnsAndLands) {
  LifeCycles lives = flying();
  EXPECT_TRUE(lives.request(0, RobotEvent::kHold));
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kHold);
  EXPECT_TRUE(lives.request(0, RobotEvent::kResume));
  EXPECT_EQ(lives.admit(0, CommandKind::kVelocity), CommandKind::kVelocity);
  EXPECT_TRUE(lives.request(0, RobotEvent::kReturn));
  EXPECT_TRUE(lives.request(0, RobotEvent::kArrived));
  EXPECT_EQ(lives.state(0), RobotState::kHolding);
  EXPECT_TRUE(lives.request(0, RobotEvent::kLand));
  EXPECT_FALSE(lives.request(0, RobotEvent::kHold)) << "a landing is not called off";
  EXPECT_EQ(lives.counters().accepted, 5U);
  EXPECT_EQ(lives.counters().refused, 1U);
}

TEST(Operator, OfARobotThatIsNotThereIsRefused) {
  LifeCycles lives({.robots = 2});
  EXPECT_FALSE(lives.request(2, RobotEvent::kHeard));
  EXPECT_FALSE(lives.request(kEveryRobot, RobotEvent::kClear));
  EXPECT_EQ(lives.counters().refused, 2U);
  LifeCycles nobody({.robots = 0});
  EXPECT_FALSE(nobody.request(0, RobotEvent::kHeard));
  EXPECT_TRUE(nobody.states().empty());
}

TEST(Robots, OneThatIsMissingBlocksNobody) {
  LifeCycles lives({.robots = 3});
  Observation missing;
  missing.now = kNow;
  missing.telemetry.heard = Time::min();
  for (int i = 0; i < 10; ++i) {
    lives.observe(0, in_air());
    lives.observe(1, missing);
    lives.observe(2, in_air());
  }
  EXPECT_EQ(lives.state(0), RobotState::kFlying);
  EXPECT_EQ(lives.state(1), RobotState::kUnknown);
  EXPECT_EQ(lives.state(2), RobotState::kFlying);
  EXPECT_EQ(lives.admit(2, CommandKind::kVelocity), CommandKind::kVelocity);
}

// Whatever is seen, asked and wished, in whatever order: each robot's life follows the table, its neighbours'
// lives do not matter to it, a velocity reaches none that does not fly, and nothing is allocated.
TEST(Robots, LiveByTheTableWhateverHappens) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&random](unsigned below) { return static_cast<unsigned>(random() % below); };
    LifeCycles together({.robots = 4});
    LifeCycles alone({.robots = 1});
    std::uint64_t allocations = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto robot = static_cast<RobotIndex>(pick(4));
      const RobotState before = together.state(robot);
      const unsigned action = pick(3);
      const std::uint64_t counted = allocation_count();
      if (action == 0) {
        const auto event = static_cast<RobotEvent>(pick(kRobotEvents));
        const bool accepted = together.request(robot, event);
        ASSERT_EQ(accepted, next_state(before, event).has_value());
        ASSERT_EQ(together.state(robot), next_state(before, event).value_or(before));
        static_cast<void>(robot == 0 && alone.request(0, event));
      } else if (action == 1) {
        Observation seen = pick(2) == 0 ? in_air() : on_ground();
        seen.now += pick(3) * kSecond;
        seen.known = pick(4) != 0;
        together.observe(robot, seen);
        if (robot == 0) {
          alone.observe(0, seen);
        }
      } else {
        const auto wish = static_cast<CommandKind>(pick(6));
        const CommandKind sent = together.admit(robot, wish);
        ASSERT_TRUE(sent != CommandKind::kVelocity || before == RobotState::kFlying ||
                    before == RobotState::kReturning);
        ASSERT_TRUE(sent != CommandKind::kTakeOff || before == RobotState::kArmed ||
                    before == RobotState::kTakingOff);
        static_cast<void>(robot == 0 ? alone.admit(0, wish) : sent);
      }
      allocations += allocation_count() - counted;
      ASSERT_EQ(together.state(0), alone.state(0));
    }
    EXPECT_EQ(allocations, 0U);
  }
}

}  // namespace
}  // namespace mayfly
