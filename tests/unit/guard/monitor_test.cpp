// Each invariant: a broken command breaks it, and one that is just right does not.
#include "controller/guard/monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/guard/wish.hpp"

namespace mayfly::test {
namespace {

constexpr Time kLife = 5 * kTick;

// Two robots 2 m apart that stand in a hall, and a tick in which nothing is wrong.
struct Rig {
  explicit Rig(const MonitorConfig& of = config()) : monitor(of) {}

  static MonitorConfig config() {
    MonitorConfig config;
    config.period = kTick;
    config.most_command_life = kLife;
    config.fence = {{0, 0, 0}, {10, 10, 10}};
    GovernorGroup group;
    group.count = 2;
    group.limits.speed = 2.0F;
    group.limits.acceleration = group.limits.braking = 4.0F;  // 0.04 m/s a tick
    group.limits.radius = 0.1F;
    config.groups = {group};
    return config;
  }

  void check() {
    now += kTick;
    ++sequence;
    monitor.check({now,
                   {commands.kind, commands.vx, commands.vy, commands.vz, now + life, sequence},
                   {x, y, z, vx, vy, vz, stamp, known, symptoms, {}, {}},
                   states,
                   severities,
                   ours,
                   governed,
                   acknowledged});
  }
  // Breaches that one more tick brings.
  std::uint64_t breaches(Invariant invariant) {
    const std::uint64_t before = monitor.counters().of(invariant);
    check();
    return monitor.counters().of(invariant) - before;
  }
  void expect_calm() {
    check();
    EXPECT_TRUE(monitor.held());
    for (std::size_t i = 0; i < kInvariants; ++i) {
      EXPECT_EQ(monitor.counters().breaches[i], 0U) << name_of(static_cast<Invariant>(i));
    }
  }

  Monitor monitor;
  WishOf commands{2, {0, 0, 0}};
  std::vector<float> x{4, 6}, y{5, 5}, z{5, 5}, vx{0, 0}, vy{0, 0}, vz{0, 0};
  std::vector<Time> stamp{Time{0}, Time{0}};
  std::vector<std::uint8_t> known{1, 1}, ours{1, 1};
  std::vector<Symptoms> symptoms{2}, governed{2};
  std::vector<RobotState> states{RobotState::kFlying, RobotState::kFlying};
  std::vector<Severity> severities{Severity::kNone, Severity::kNone};
  bool acknowledged = false;
  Time now{0};
  Time life = kLife;
  std::uint64_t sequence = 0;
};

TEST(Monitor, FindsNothingWhereNothingIsWrong) {
  Rig rig;
  for (int i = 0; i < 100; ++i) {
    rig.commands.vx[0] = -0.04F * static_cast<float>(std::min(i, 40));
    rig.x[0] = 4.0F;
    rig.expect_calm();
  }
  EXPECT_EQ(rig.monitor.counters().ticks, 100U);
  EXPECT_EQ(rig.monitor.counters().ticks_that_held, 100U);
}

TEST(Monitor, I1WhatIsNoNumberIsNotSent) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Rig rig;
    rig.expect_calm();
    rig.commands.vz[1] = bad;
    EXPECT_EQ(rig.breaches(Invariant::kFinite), 1U);
    EXPECT_FALSE(rig.monitor.may_send(1));
    EXPECT_TRUE(rig.monitor.may_send(0));
    EXPECT_TRUE(rig.monitor.symptoms()[1].has(Symptom::kLimitBroken));
    rig.commands.kind[1] = CommandKind::kHold;
    EXPECT_EQ(rig.breaches(Invariant::kFinite), 0U) << "of a hold it does not count";
  }
}

TEST(Monitor, I2SpeedIsWithinTheLimit) {
  Rig rig;
  rig.commands.vx[0] = 2.0F;  // the first command: any change will do
  rig.expect_calm();
  rig.commands.vx[0] = 2.001F;
  EXPECT_EQ(rig.breaches(Invariant::kSpeed), 1U);
  EXPECT_TRUE(rig.monitor.symptoms()[0].has(Symptom::kLimitBroken));
}

TEST(Monitor, I3ChangeIsWithinTheLimit) {
  Rig rig;
  rig.expect_calm();
  rig.commands.vy[0] = 0.04F;
  rig.expect_calm();
  rig.commands.vy[0] = 0.081F;
  EXPECT_EQ(rig.breaches(Invariant::kAcceleration), 1U);
  rig.commands.vy[0] = 0.05F;
  rig.commands.kind[1] = CommandKind::kHold;
  EXPECT_EQ(rig.breaches(Invariant::kAcceleration), 0U);
  rig.commands.kind[0] = CommandKind::kHold;
  EXPECT_EQ(rig.breaches(Invariant::kAcceleration), 0U) << "who is told to hold brakes by itself";
  rig.commands.kind[0] = CommandKind::kVelocity;
  EXPECT_EQ(rig.breaches(Invariant::kAcceleration), 1U) << "from rest";
}

TEST(Monitor, I4StoppingPathsKeepTheirDistance) {
  Rig rig;
  rig.commands.vx[0] = 2.0F;  // rests 0.5 m further
  rig.x[1] = 4.71F;
  rig.expect_calm();
  rig.x[1] = 4.69F;
  EXPECT_EQ(rig.breaches(Invariant::kSeparation), 1U);
  EXPECT_TRUE(rig.monitor.symptoms()[0].has(Symptom::kTooNear));
  EXPECT_TRUE(rig.monitor.symptoms()[1].has(Symptom::kTooNear));
  rig.ours[1] = 0;
  EXPECT_EQ(rig.breaches(Invariant::kSeparation), 0U) << "of one that is not ours nothing is promised";
}

TEST(Monitor, I5StoppingPathsStayInTheFence) {
  Rig rig;
  rig.commands.vz[0] = 2.0F;
  rig.z[0] = 9.39F;
  rig.expect_calm();
  rig.z[0] = 9.41F;
  EXPECT_EQ(rig.breaches(Invariant::kFence), 1U);
  EXPECT_TRUE(rig.monitor.symptoms()[0].has(Symptom::kOutOfFence));
}

// Slanted, and not of length 1: x + z <= 12 in the rig's hall, the robot at (6, 5, 5).
TEST(Monitor, I5AHalfSpaceIsAFenceToo) {
  MonitorConfig config = Rig::config();
  config.half_spaces = {{{2.0F, 0.0F, 2.0F}, 24.0F}};
  const float border = (12.0F - 0.1F * std::sqrt(2.0F)) - 5.0F;  // where a body of 0.1 m just fits
  Rig rig(config);
  rig.x[1] = border - 1e-3F;
  rig.expect_calm();
  rig.expect_calm();
  rig.commands.vx[1] = 0.04F;  // braked after 0.2 mm
  EXPECT_EQ(rig.breaches(Invariant::kFence), 0U);
  rig.x[1] = border + 1e-3F;  // an estimate that is outside already, and goes on outwards
  rig.commands.vx[1] = 0.08F;
  EXPECT_EQ(rig.breaches(Invariant::kFence), 1U);
  EXPECT_TRUE(rig.monitor.symptoms()[1].has(Symptom::kOutOfFence));
  EXPECT_FALSE(rig.monitor.symptoms()[0].has(Symptom::kOutOfFence));
  rig.commands.vx[1] = 0.04F;
  rig.commands.vz[1] = -0.04F;
  EXPECT_EQ(rig.breaches(Invariant::kFence), 0U) << "along the plane";
}

// Three times as far above each other as beside: of two kinds the smaller counts.
TEST(Monitor, I4HeightsAreMeasuredByTheDownwash) {
  MonitorConfig config = Rig::config();
  config.groups[0].limits.downwash = 3.0F;
  Rig rig(config);
  rig.x = {5, 5};
  rig.z = {5, 5.61F};
  rig.expect_calm();
  rig.expect_calm();
  rig.z[1] = 5.59F;
  EXPECT_EQ(rig.breaches(Invariant::kSeparation), 1U);
  rig.z[1] = 5.0F;
  rig.x[1] = 5.21F;
  EXPECT_EQ(rig.breaches(Invariant::kSeparation), 0U) << "beside each other it changes nothing";

  GovernorGroup other = config.groups[0];
  config.groups[0].count = 1;
  other.first = other.count = 1;
  other.limits.downwash = 2.0F;
  config.groups.push_back(other);
  Rig mixed(config);
  mixed.x = {5, 5};
  mixed.z = {5, 5.41F};
  mixed.expect_calm();
  mixed.expect_calm();
  mixed.z[1] = 5.39F;
  EXPECT_EQ(mixed.breaches(Invariant::kSeparation), 1U);
}

TEST(Monitor, I5OneThatIsOutsideMayComeBack) {
  Rig rig;
  rig.x[0] = -1.0F;
  rig.expect_calm();
  rig.commands.vx[0] = 0.04F;
  rig.expect_calm();
  for (float v = 0.0F; v > -0.3F; v -= 0.04F) {
    rig.commands.vx[0] = v;
    rig.check();
  }
  EXPECT_GT(rig.monitor.counters().of(Invariant::kFence), 0U) << "farther out it may not";
}

TEST(Monitor, I6NobodyGetsFasterWhosePlaceIsNotKnown) {
  Rig rig;
  rig.commands.vx[0] = 1.0F;
  rig.expect_calm();
  rig.known[0] = 0;
  rig.commands.vx[0] = 0.97F;
  rig.expect_calm();
  rig.commands.vx[0] = 1.0F;
  EXPECT_EQ(rig.breaches(Invariant::kAges), 1U);
}

TEST(Monitor, I6DeadlinesLieAheadAndNotTooFar) {
  Rig rig;
  rig.expect_calm();
  rig.life = kLife + Time(1);
  EXPECT_EQ(rig.breaches(Invariant::kAges), 1U);
  rig.life = Time{0};
  EXPECT_EQ(rig.breaches(Invariant::kAges), 1U);
  rig.life = Time(1);
  EXPECT_EQ(rig.breaches(Invariant::kAges), 0U);
}

TEST(Monitor, I7TheTubeHolds) {
  Rig rig;
  rig.expect_calm();
  rig.check();
  rig.governed[1].add(Symptom::kTrackingError);
  EXPECT_EQ(rig.breaches(Invariant::kTracking), 1U);
  EXPECT_TRUE(rig.monitor.symptoms()[1].has(Symptom::kTrackingError));
}

TEST(Monitor, I8NumbersRiseAndEverybodyHasACommand) {
  Rig rig;
  rig.expect_calm();
  --rig.sequence;
  EXPECT_EQ(rig.breaches(Invariant::kSequence), 1U) << "the same number again";
  EXPECT_EQ(rig.breaches(Invariant::kSequence), 0U);
  rig.commands.kind.push_back(CommandKind::kHold);
  EXPECT_EQ(rig.breaches(Invariant::kSequence), 1U) << "a command for nobody";
  EXPECT_TRUE(rig.monitor.everybody().has(Symptom::kInvariantBroken));
}

TEST(Monitor, I9NobodyMovesWhoseMotorsMayNotTurn) {
  for (const RobotState state :
       {RobotState::kUnknown, RobotState::kConnected, RobotState::kChecked, RobotState::kOff}) {
    Rig rig;
    rig.states[0] = state;
    rig.expect_calm();
    rig.commands.vx[0] = 0.01F;
    EXPECT_EQ(rig.breaches(Invariant::kArmed), 1U) << static_cast<int>(state);
    rig.commands.vx[0] = 0.0F;
    rig.commands.kind[0] = CommandKind::kTakeOff;
    EXPECT_EQ(rig.breaches(Invariant::kArmed), 1U);
    rig.commands.kind[0] = CommandKind::kStop;
    EXPECT_EQ(rig.breaches(Invariant::kArmed), 0U);
  }
}

TEST(Monitor, I10StatesFollowTheTable) {
  Rig rig;
  rig.expect_calm();
  rig.states[0] = RobotState::kHolding;
  rig.expect_calm();
  rig.states[0] = RobotState::kArmed;
  EXPECT_EQ(rig.breaches(Invariant::kTransition), 1U) << "nobody is armed from a hold";
  EXPECT_EQ(rig.breaches(Invariant::kTransition), 0U) << "told once";
}

TEST(Monitor, I10OneThatIsFoundInTheAirFliesAtOnce) {
  Rig rig;
  rig.states[0] = RobotState::kUnknown;
  rig.expect_calm();
  rig.states[0] = RobotState::kFlying;
  rig.expect_calm();
}

TEST(Monitor, I11FromHoldAllNothingFallsUnacknowledged) {
  Rig rig;
  rig.severities[0] = Severity::kHold;
  rig.expect_calm();
  rig.severities[0] = Severity::kNone;
  rig.expect_calm();
  rig.severities[0] = Severity::kLand;
  rig.expect_calm();
  rig.severities[0] = Severity::kHoldAll;
  EXPECT_EQ(rig.breaches(Invariant::kSeverity), 1U);
  rig.acknowledged = true;
  rig.severities[0] = Severity::kNone;
  EXPECT_EQ(rig.breaches(Invariant::kSeverity), 0U);
}

TEST(Monitor, I12ATickEndsWithinItsBudget) {
  MonitorConfig config = Rig::config();
  config.tick_budget = kTick;
  Rig rig(config);
  rig.monitor.took(kTick);
  rig.expect_calm();
  rig.monitor.took(kTick + Time(1));
  EXPECT_EQ(rig.breaches(Invariant::kTickBudget), 1U);
  EXPECT_TRUE(rig.monitor.everybody().has(Symptom::kTickLate));
  Rig unwatched;
  unwatched.monitor.took(std::chrono::hours(1));
  unwatched.expect_calm();
}

TEST(Monitor, I13NothingIsAllocated) {
  MonitorConfig config = Rig::config();
  std::uint64_t allocations = 1000;  // before the first tick
  config.hooks.allocations = [&] { return allocations; };
  Rig rig(config);
  rig.expect_calm();
  rig.expect_calm();
  ++allocations;
  EXPECT_EQ(rig.breaches(Invariant::kNoAllocation), 1U);
  EXPECT_EQ(rig.breaches(Invariant::kNoAllocation), 0U) << "each is told once";
}

TEST(Monitor, I14WhatWasEncodedDecodes) {
  Rig rig;
  for (const HalFault other : {HalFault::kNone, HalFault::kLinkDown, HalFault::kRobotSilent}) {
    rig.monitor.wrote({other});
    rig.expect_calm();
  }
  rig.monitor.wrote({HalFault::kMisencoded, 1});
  EXPECT_EQ(rig.monitor.counters().of(Invariant::kDecodes), 1U);
  EXPECT_EQ(rig.monitor.counters().ticks_that_held, rig.monitor.counters().ticks - 1);
  EXPECT_FALSE(rig.monitor.held()) << "no watchdog is fed";
  EXPECT_TRUE(rig.monitor.symptoms()[1].has(Symptom::kInvariantBroken));
  rig.monitor.wrote({HalFault::kMisencoded, kEveryRobot});
  EXPECT_TRUE(rig.monitor.everybody().has(Symptom::kInvariantBroken));
  rig.check();
  EXPECT_TRUE(rig.monitor.held()) << "until the next that is right";
}

TEST(Monitor, I16NobodyElseCommands) {
  MonitorConfig config = Rig::config();
  bool owns = true;
  config.hooks.owns_commands = [&] { return owns; };
  Rig rig(config);
  rig.expect_calm();
  owns = false;
  EXPECT_EQ(rig.breaches(Invariant::kOneOwner), 1U);
}

// I17: one breach of any, and no watchdog is fed in that tick.
TEST(Monitor, I17HeldOnlyWhereAllHold) {
  Rig rig;
  rig.expect_calm();
  rig.commands.vx[1] = 99.0F;
  rig.check();
  EXPECT_FALSE(rig.monitor.held());
  rig.commands.vx[1] = 98.99F;
  rig.check();
  EXPECT_FALSE(rig.monitor.held()) << "not until it is legal again";
}

TEST(Monitor, OfTheUngovernedOnlyNumbersAndSpeedAreAsked) {
  MonitorConfig config = Rig::config();
  config.groups[0].enabled = false;
  Rig rig(config);
  rig.x = {5, 5};
  rig.expect_calm();
  rig.commands.vx[0] = 2.0F;
  rig.x[0] = 42.0F;
  rig.expect_calm();
  rig.commands.vx[0] = 2.1F;
  EXPECT_EQ(rig.breaches(Invariant::kSpeed), 1U);
}

TEST(Monitor, AfterAResetNothingOfBeforeCounts) {
  Rig rig;
  rig.severities[0] = Severity::kCut;
  rig.check();
  rig.monitor.reset();
  rig.sequence = 0;
  rig.severities[0] = Severity::kNone;
  rig.commands.vx[0] = 2.0F;
  rig.expect_calm();
}

}  // namespace
}  // namespace mayfly::test
