// A broken part inside a whole guard: the right invariant finds it, in its tick; the table answers in the
// next; the black box keeps the last five seconds. One step below nothing happens.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "tests/unit/guard/field_trip.hpp"

namespace mayfly::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// What a broken part may change in a tick: what is to be sent, and what is told of it.
struct Break {
  GovernedColumns sent;
  TickOutcome& told;
  // With room to lie in.
  std::vector<float> x, y;
  std::vector<RobotState> states;
  std::vector<Severity> severities;
};

struct Case {
  std::string name;
  Invariant invariant;
  Severity severity;  // of the robot at fault, in the next tick
  std::function<void(Break&)> broken, just_right;
};

void lie_x(Break& b, float by) {
  b.x.assign(b.told.estimate.x.begin(), b.told.estimate.x.end());
  b.x[1] += by;
  b.told.estimate.x = b.x;
}
void lie_y(Break& b, float at) {
  b.y.assign(b.told.estimate.y.begin(), b.told.estimate.y.end());
  b.y[1] = at;
  b.told.estimate.y = b.y;
}
void lie_state(Break& b, RobotState state) {
  b.states.assign(b.told.states.begin(), b.told.states.end());
  b.states[1] = state;
  b.told.states = b.states;
}

// All fly along y at their limit of 2 m/s; a tick's change is at most 0.04 m/s, the way to rest 0.5 m.
std::vector<Case> cases() {
  const auto nothing = [](Break&) {};
  return {
      {"finite", Invariant::kFinite, Severity::kHold, [](Break& b) { b.sent.vx[1] = kNan; }, nothing},
      {"speed", Invariant::kSpeed, Severity::kHold, [](Break& b) { b.sent.vy[1] = 2.01F; },
       [](Break& b) { b.sent.vy[1] = 2.0F; }},
      {"acceleration", Invariant::kAcceleration, Severity::kHold, [](Break& b) { b.sent.vy[1] = 1.955F; },
       [](Break& b) { b.sent.vy[1] = 1.965F; }},
      {"separation", Invariant::kSeparation, Severity::kClamp, [](Break& b) { lie_x(b, -0.41F); },
       [](Break& b) { lie_x(b, -0.39F); }},
      {"fence", Invariant::kFence, Severity::kClamp, [](Break& b) { lie_y(b, 19.42F); },
       [](Break& b) { lie_y(b, 19.38F); }},
      {"deadline", Invariant::kAges, Severity::kHoldAll,
       [](Break& b) { b.told.commands.deadline += Time(1); },
       [](Break& b) { b.told.commands.deadline -= Time(1); }},
      {"tracking", Invariant::kTracking, Severity::kHold,
       [](Break& b) { b.sent.symptoms[1].add(Symptom::kTrackingError); }, nothing},
      {"sequence", Invariant::kSequence, Severity::kHoldAll, [](Break& b) { --b.told.commands.sequence; },
       nothing},
      {"armed", Invariant::kArmed, Severity::kHoldAll, [](Break& b) { lie_state(b, RobotState::kOff); },
       [](Break& b) { lie_state(b, RobotState::kLanding); }},
      {"transition", Invariant::kTransition, Severity::kHoldAll,
       [](Break& b) { lie_state(b, RobotState::kTakingOff); },
       [](Break& b) { lie_state(b, RobotState::kHolding); }},
  };
}

class BrokenPart : public ::testing::Test {
 protected:
  static std::vector<glm::vec3> places() { return {{4, 2, 10}, {4.6F, 2, 10}, {8, 2, 10}}; }
  static GuardConfig config() {
    GuardConfig config = guard_of(3);
    config.black_box.seconds = 5.0;
    return config;
  }

  // Flies for so long that the black box is full, then one tick in which `deed` is done.
  void fly(GuardConfig config, const std::function<void(Break&)>& deed) {
    config.tamper = [this](const GovernedColumns& sent, TickOutcome& told) {
      if (broken_) {
        break_ = std::make_unique<Break>(Break{sent, told, {}, {}, {}, {}});
        deed_(*break_);
      }
    };
    deed_ = deed;
    trip_ = std::make_unique<FieldTrip>(places(), std::move(config));
    trip_->wish = WishOf(3, {0, 2, 0});
    trip_->fly(6);
    EXPECT_TRUE(trip_->guard->held());
    broken_ = true;
    trip_->tick();
    broken_ = false;
  }
  std::uint64_t breaches(Invariant invariant) const {
    return trip_->guard->report().invariants.of(invariant);
  }
  std::uint64_t all_breaches() const {
    std::uint64_t all = 0;
    for (const std::uint64_t of_one : trip_->guard->report().invariants.breaches) {
      all += of_one;
    }
    return all;
  }
  // The last five seconds, the tick in which it happened the last of them.
  void expect_sealed() const {
    const BlackBoxTape* tape = trip_->guard->black_box().sealed();
    ASSERT_NE(tape, nullptr);
    ASSERT_EQ(tape->size(), 500U);
    EXPECT_EQ(tape->frame(499).time, trip_->now);
    EXPECT_FALSE(tape->frame(499).held);
    EXPECT_TRUE(tape->frame(498).held);
    EXPECT_EQ(tape->frame(499).time - tape->frame(0).time, 499 * kTick);
  }

  std::unique_ptr<FieldTrip> trip_;
  std::unique_ptr<Break> break_;
  std::function<void(Break&)> deed_;
  bool broken_ = false;
};

TEST_F(BrokenPart, IsFoundInItsTickAnsweredInTheNextAndOnTape) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    fly(config(), one.broken);
    EXPECT_EQ(breaches(one.invariant), 1U);
    EXPECT_EQ(all_breaches(), 1U) << "nothing else is blamed";
    EXPECT_FALSE(trip_->guard->held()) << "no watchdog is fed (I17)";
    expect_sealed();
    trip_->tick();
    EXPECT_EQ(trip_->severity(1), one.severity);
    const bool everybody = one.severity == Severity::kHoldAll;
    EXPECT_EQ(trip_->severity(2), everybody ? Severity::kHoldAll : Severity::kNone);
    EXPECT_EQ(trip_->guard->report().incidents, 1U + (everybody ? 1U : 0U));
  }
}

TEST_F(BrokenPart, OneStepBelowNothingHappens) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    fly(config(), one.just_right);
    EXPECT_EQ(all_breaches(), 0U);
    EXPECT_TRUE(trip_->guard->held());
    EXPECT_EQ(trip_->guard->black_box().sealed(), nullptr);
  }
}

TEST_F(BrokenPart, WhatIsNoNumberIsNotSent) {
  fly(config(), [](Break& b) { b.sent.vx[1] = kNan; });
  EXPECT_EQ(trip_->robots.kind[1], CommandKind::kHold);
  EXPECT_EQ(trip_->robots.kind[0], CommandKind::kVelocity);
}

TEST_F(BrokenPart, ASeverityThatFallsByItselfHoldsEverybody) {
  fly(config(), [](Break&) {});
  trip_->guard->tell(Symptom::kOperatorHold);
  trip_->tick();
  deed_ = [](Break& b) {
    b.severities.assign(3, Severity::kNone);
    b.told.severities = b.severities;
  };
  broken_ = true;
  trip_->tick();
  EXPECT_EQ(breaches(Invariant::kSeverity), 3U) << "of three robots";
  EXPECT_EQ(all_breaches(), 3U);
  expect_sealed();
}

TEST_F(BrokenPart, AnAllocationABadEncodingAndASecondOwnerHoldEverybody) {
  std::uint64_t allocations = 7;
  bool owns = true;
  GuardConfig watched = config();
  watched.hooks.allocations = [&] { return allocations; };
  watched.hooks.owns_commands = [&] { return owns; };
  const std::vector<std::pair<Invariant, std::function<void(Break&)>>> deeds{
      {Invariant::kNoAllocation, [&](Break&) { ++allocations; }},
      {Invariant::kDecodes,
       [&](Break&) {
         trip_->robots.write_result = {HalFault::kMisencoded, 1, "first", "does not decode"};
       }},
      {Invariant::kOneOwner, [&](Break&) { owns = false; }}};
  for (const auto& [invariant, deed] : deeds) {
    SCOPED_TRACE(name_of(invariant));
    fly(watched, deed);
    trip_->robots.write_result = {};
    owns = true;
    EXPECT_EQ(breaches(invariant), 1U);
    EXPECT_EQ(all_breaches(), 1U);
    EXPECT_FALSE(trip_->guard->held());
    if (invariant != Invariant::kDecodes) {
      expect_sealed();
    }
    trip_->tick();
    EXPECT_EQ(trip_->severity(2), Severity::kHoldAll);
    EXPECT_NE(trip_->guard->black_box().sealed(), nullptr);
  }
}

// The run's clock, which a test moves.
class HandClock final : public Clock {
 public:
  Time now() const noexcept override { return at; }
  bool is_virtual() const noexcept override { return false; }
  void sleep_until(Time) noexcept override {}
  Time at{0};
};

TEST_F(BrokenPart, ATickThatTakesTooLongIsTold) {
  HandClock clock;
  GuardConfig timed = config();
  timed.clock = &clock;
  timed.tick_budget = kTick;
  for (const bool late : {false, true}) {
    // Asked for when a tick ends.
    fly(timed, [&](Break& b) { clock.at = b.told.now + kTick + (late ? Time(1) : Time(0)); });
    trip_->tick();
    EXPECT_EQ(breaches(Invariant::kTickBudget), late ? 1U : 0U);
    EXPECT_EQ(trip_->guard->everybody().has(Symptom::kTickLate), false) << "told in the tick after";
    clock.at = Time(0);
    trip_->tick();
    EXPECT_EQ(trip_->guard->everybody().has(Symptom::kTickLate), late);
    EXPECT_EQ(trip_->severity(0), late ? Severity::kReport : Severity::kNone);
    clock.at = Time(0);
  }
}

}  // namespace
}  // namespace mayfly::test
