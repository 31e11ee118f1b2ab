#include "controller/link/flight_end.hpp"

#include <gtest/gtest.h>

namespace mayfly::link {
namespace {

using Stage = FlightEnd::Stage;
constexpr Time kStep{10'000'000};
constexpr FlightEnd::Seen kFlies{.airborne = true};
constexpr FlightEnd::Seen kEnds{.end_wanted = true, .airborne = true};
constexpr FlightEnd::Seen kEndsAtRest{.end_wanted = true, .all_still = true, .airborne = true};
constexpr FlightEnd::Seen kDies{.planner_died = true, .airborne = true};
constexpr FlightEnd::Seen kRests{.planner_died = true, .all_still = true, .airborne = true};
constexpr FlightEnd::Seen kIsDown{.planner_died = true, .all_still = true, .airborne = false};

TEST(FlightEnd, NothingEndsThatNobodyWantsToEnd) {
  FlightEnd end;
  for (Time now{0}; now < 2 * FlightEnd::kMostLanding; now += kStep) {
    EXPECT_EQ(end.update(now, kFlies), Stage::kFlying);
    EXPECT_EQ(end.update(now, {.all_still = true}), Stage::kFlying);
  }
}

TEST(FlightEnd, OneThatIsWantedIsDoneAtRest) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kEnds), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kEnds), Stage::kBraking);
  EXPECT_EQ(end.update(3 * kStep, kEndsAtRest), Stage::kDone);
  EXPECT_EQ(end.update(4 * kStep, kFlies), Stage::kDone);
}

TEST(FlightEnd, WhereThePlannerDiesTheyHoldThenLandThenAreLetGo) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kDies), Stage::kBraking);
  const Time held = kStep + FlightEnd::kHolding;
  EXPECT_EQ(end.update(held - Time(1), kRests), Stage::kBraking);
  EXPECT_EQ(end.update(held, kDies), Stage::kBraking);
  EXPECT_EQ(end.update(held, kRests), Stage::kLanding);
  EXPECT_EQ(end.update(held + kStep, kRests), Stage::kLanding);
  EXPECT_EQ(end.update(held + 2 * kStep, kIsDown), Stage::kDone);
}

TEST(FlightEnd, WhereItDiesWhileTheyBrakeForItTheyLandAsWell) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kEnds), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kDies), Stage::kBraking);
  EXPECT_EQ(end.update(kStep + FlightEnd::kHolding, kRests), Stage::kLanding);
}

TEST(FlightEnd, IsNotCalledOffByAPlannerThatChangesItsMind) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kEnds), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kFlies), Stage::kBraking);
}

TEST(FlightEnd, WhoeverStillSinksIsWaitedForButNotForEver) {
  constexpr FlightEnd::Seen kSinks{
      .planner_died = true, .all_still = false, .airborne = true, .sinking = true};
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kDies), Stage::kBraking);
  Time now = kStep + FlightEnd::kHolding;
  EXPECT_EQ(end.update(now, kRests), Stage::kLanding);
  const Time landing = now;
  now += 3 * FlightEnd::kMostLanding;
  EXPECT_EQ(end.update(now, kSinks), Stage::kLanding) << "from high up";
  EXPECT_EQ(end.update(now + FlightEnd::kMostLanding, kRests), Stage::kLanding);
  EXPECT_EQ(end.update(now + FlightEnd::kMostLanding + Time(1), kRests), Stage::kDone);

  FlightEnd endless;
  EXPECT_EQ(endless.update(kStep, kDies), Stage::kBraking);
  EXPECT_EQ(endless.update(landing, kRests), Stage::kLanding);
  EXPECT_EQ(endless.update(landing + FlightEnd::kMostAltogether, kSinks), Stage::kLanding);
  EXPECT_EQ(endless.update(landing + FlightEnd::kMostAltogether + Time(1), kSinks), Stage::kDone);
}

TEST(FlightEnd, NeitherBrakingNorLandingTakesForEver) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kDies), Stage::kBraking);
  EXPECT_EQ(end.update(kStep + FlightEnd::kMostBraking, kDies), Stage::kBraking);
  const Time landing = kStep + FlightEnd::kMostBraking + Time(1);
  EXPECT_EQ(end.update(landing, kDies), Stage::kLanding);
  EXPECT_EQ(end.update(landing + FlightEnd::kMostLanding, kDies), Stage::kLanding);
  EXPECT_EQ(end.update(landing + FlightEnd::kMostLanding + Time(1), kDies), Stage::kDone);
}

}  // namespace
}  // namespace mayfly::link
