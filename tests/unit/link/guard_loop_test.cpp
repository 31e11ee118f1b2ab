// The guard's ticks over a link, on a clock of the test's: every bound in ticks, nothing in wall time.
#include "controller/link/guard_loop.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "controller/clock/virtual_clock.hpp"
#include "tests/unit/guard/field_trip.hpp"
#include "tests/unit/link/link_pair.hpp"

namespace mayfly::link::test {
namespace {

using mayfly::test::guard_of;
using mayfly::test::kTick;
using mayfly::test::Robots;

constexpr std::size_t kRobots = 3;
constexpr float kSpeed = 0.5F;  // m/s

class Loop : public ::testing::Test {
 protected:
  Loop()
      : link_(kRobots),
        robots_({{4, 4, 0.6F}, {8, 4, 0.8F}, {4, 8, 1.0F}}),
        start_(configured()),
        guard_(std::move(*Guard::create(guard_of(kRobots), robots_))),
        loop_({*guard_, link_.guard, clock_, planner_gone_, asked_}) {
    EXPECT_TRUE(robots_.activate(clock_.now()));
    link_.planner.want(Want::kFly);
  }
  bool configured() {
    clock_.sleep_until(std::chrono::seconds(1));
    return robots_.configure().has_value();
  }

  // One of the guard's ticks; with a wish of this speed before it, unless it is negative.
  void tick(float speed, std::uint64_t skipped = 0, Time late = Time(0)) {
    const Time scheduled = clock_.now() + static_cast<Time::rep>(1 + skipped) * kTick;
    if (speed >= 0.0F) {
      const Time now = clock_.now();
      link_.wish_velocity(speed, now, now + 5 * kTick);
    }
    clock_.sleep_until(scheduled + late);
    loop_.tick({++release_, skipped, scheduled, clock_.now(), kTick});
    // The next tick is not late because this one was.
    clock_.sleep_until(clock_.now());
  }
  void fly(int ticks) {
    for (int k = 0; k < ticks; ++k) {
      tick(kSpeed);
    }
  }
  // Ticks without a wish until the condition holds; as many as that took, or `most` + 1.
  int ticks_until(const std::function<bool()>& condition, int most) {
    int ticks = 0;
    while (ticks <= most && !condition()) {
      tick(-1.0F);
      ++ticks;
    }
    return ticks;
  }
  bool all_stand() const {
    return std::all_of(robots_.velocity.begin(), robots_.velocity.end(),
                       [](glm::vec3 v) { return v == glm::vec3(0); });
  }

  VirtualClock clock_;
  Pair link_;
  Robots robots_;
  bool start_;
  std::unique_ptr<Guard> guard_;
  std::atomic<bool> planner_gone_{false};
  std::atomic<int> asked_{0};
  GuardLoop loop_;
  std::uint64_t release_ = 0;
};

// m/s, and m/s² for a tick: 0.5 / (4 · 0.01) is 12.5 ticks.
constexpr int kBrakingTicks = 13;

TEST_F(Loop, FliesWhatThePlannerWishes) {
  fly(30);
  EXPECT_NEAR(robots_.velocity[0].x, kSpeed, 1e-5);
  EXPECT_EQ(loop_.report().wishes, 30U);
  EXPECT_FALSE(loop_.finished());
}

TEST_F(Loop, APlannerThatDiesLetsThemBrakeInTheSameTick) {
  fly(30);
  planner_gone_ = true;
  tick(-1.0F);
  EXPECT_LT(robots_.velocity[0].x, kSpeed);
  EXPECT_LE(ticks_until([&] { return all_stand(); }, 100), kBrakingTicks);
  const LinkReport report = loop_.report();
  EXPECT_TRUE(report.planner_died);
  ASSERT_EQ(report.stops.size(), 1U);
  EXPECT_LE(report.stops[0].still - report.stops[0].wished, (kBrakingTicks + 2) * kTick);
  EXPECT_EQ(report.stops[0].late, Time(0));
}

// A wish lives five periods: at its last they fly on, a tick later they brake.
TEST_F(Loop, APlannerThatHangsLetsThemBrakeWhenItsWishRunsOut) {
  fly(30);
  for (int k = 0; k < 4; ++k) {
    tick(-1.0F);
    EXPECT_NEAR(robots_.velocity[0].x, kSpeed, 1e-5) << k;
  }
  tick(-1.0F);
  EXPECT_LT(robots_.velocity[0].x, kSpeed);
  EXPECT_LE(ticks_until([&] { return all_stand(); }, 100), kBrakingTicks);
  EXPECT_FALSE(loop_.report().planner_died);
  EXPECT_FALSE(loop_.finished());
  // It goes on before everybody is held for good: so do they.
  fly(30);
  EXPECT_NEAR(robots_.velocity[0].x, kSpeed, 1e-5);
  EXPECT_EQ(loop_.report().stops.size(), 1U);
}

TEST_F(Loop, AStopThatTheMachineMadeLateSaysByHowMuch) {
  fly(30);
  planner_gone_ = true;
  tick(-1.0F, 3, Time(2'000'000));
  static_cast<void>(ticks_until([&] { return all_stand(); }, 100));
  ASSERT_EQ(loop_.report().stops.size(), 1U);
  EXPECT_EQ(loop_.report().stops[0].late, 3 * kTick + Time(2'000'000));
  EXPECT_EQ(loop_.report().skipped, 3U);
}

TEST_F(Loop, AnEndThatIsWantedIsReachedAtRest) {
  fly(30);
  link_.planner.want(Want::kEnd);
  EXPECT_LE(ticks_until([&] { return loop_.finished().load(); }, 100), kBrakingTicks + 3);
  EXPECT_TRUE(all_stand());
  EXPECT_EQ(robots_.kind[0], CommandKind::kHold);
  EXPECT_FALSE(loop_.report().planner_died);
}

TEST_F(Loop, ADeadPlannersRobotsLandAndAreLetGo) {
  fly(30);
  planner_gone_ = true;
  const auto everybody_lands = [&] {
    for (std::size_t robot = 0; robot < kRobots; ++robot) {
      robots_.telemetry[robot].airborne = robots_.kind[robot] != CommandKind::kLand;
      robots_.telemetry[robot].heard = clock_.now();
    }
    return loop_.finished().load();
  };
  const int ticks = ticks_until(everybody_lands, 3000);
  EXPECT_GT(ticks * kTick, FlightEnd::kHolding);
  EXPECT_LT(ticks * kTick, FlightEnd::kHolding + FlightEnd::kMostLanding);
  for (const RobotState state : guard_->states()) {
    EXPECT_EQ(state, RobotState::kOff);
  }
}

TEST_F(Loop, OneRequestToStopHoldsTwoCutInTheSameTick) {
  fly(30);
  link_.planner.request_stop(StopLevel::kHold);
  tick(kSpeed);
  EXPECT_LT(robots_.velocity[0].x, kSpeed);
  EXPECT_EQ(robots_.kind[0], CommandKind::kVelocity);
  link_.planner.request_stop(StopLevel::kEmergencyStop);
  tick(kSpeed);
  for (const CommandKind kind : robots_.kind) {
    EXPECT_EQ(kind, CommandKind::kStop);
  }
}

TEST_F(Loop, ItsOwnSignalsCountAsThePlannersDo) {
  fly(30);
  asked_ = 1;
  tick(kSpeed);
  EXPECT_LT(robots_.velocity[0].x, kSpeed);
  asked_ = 2;
  tick(kSpeed);
  EXPECT_EQ(robots_.kind[0], CommandKind::kStop);
}

TEST_F(Loop, AHoldIsLatchedUntilItIsAcknowledged) {
  fly(30);
  link_.planner.request_stop(StopLevel::kHold);
  tick(kSpeed);
  link_.planner.request_stop(StopLevel::kNone);
  fly(40);
  EXPECT_TRUE(all_stand());
  link_.planner.acknowledge();
  fly(40);
  EXPECT_NEAR(robots_.velocity[0].x, kSpeed, 1e-5);
}

TEST_F(Loop, ShowsWhatItKnowsAndDoes) {
  fly(5);
  ASSERT_TRUE(link_.planner.collect());
  const ViewColumns& view = link_.planner.view();
  EXPECT_EQ(view.head->tick, 5U);
  EXPECT_EQ(view.head->wish, 5U);
  EXPECT_EQ(view.report->ticks, 5U);
  EXPECT_EQ(view.x[1], robots_.at[1].x);
  EXPECT_EQ(view.fresh[2], 1);
  EXPECT_EQ(view.sent_vx[0], robots_.velocity[0].x);
  EXPECT_EQ(view.kind[0], static_cast<std::uint8_t>(CommandKind::kVelocity));
  EXPECT_EQ(view.state[0], static_cast<std::uint8_t>(RobotState::kFlying));
}

TEST_F(Loop, TellsOfReactionsAndOfWhatTheHalSays) {
  fly(5);
  while (link_.planner.next_event()) {
  }
  robots_.read_result = {HalFault::kRobotSilent, 1, "first", "no answer"};
  tick(kSpeed);
  tick(kSpeed);  // goes on: one event
  robots_.read_result = {};
  const auto event = link_.planner.next_event();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->fault, static_cast<std::uint32_t>(HalFault::kRobotSilent));
  EXPECT_EQ(event->robot, 1U);
  EXPECT_STREQ(event->link.data(), "first");
  EXPECT_STREQ(event->cause.data(), "no answer");
  EXPECT_FALSE(link_.planner.next_event());
  asked_ = 1;
  tick(kSpeed);
  const auto reaction = link_.planner.next_event();
  ASSERT_TRUE(reaction);
  EXPECT_EQ(reaction->fault, 0U);
  EXPECT_EQ(reaction->symptom, static_cast<std::uint32_t>(Symptom::kOperatorHold));
  EXPECT_EQ(reaction->severity, static_cast<std::uint32_t>(Severity::kHoldAll));
}

}  // namespace
}  // namespace mayfly::link::test
