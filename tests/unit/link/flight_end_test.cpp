#include "controller/link/flight_end.hpp"

#include <gtest/gtest.h>

namespace mayfly::link {
namespace {

using Stage = FlightEnd::Stage;
constexpr Time kStep{10'000'000};
constexpr FlightEnd::Seen kFlies{.airborne = true};
constexpr FlightEnd::Seen kMoves{.end_wanted = true, .airborne = true};
constexpr FlightEnd::Seen kRests{.end_wanted = true, .all_still = true, .airborne = true};
constexpr FlightEnd::Seen kIsDown{.end_wanted = true, .all_still = true, .airborne = false};

TEST(FlightEnd, NothingEndsThatNobodyWantsToEnd) {
  FlightEnd end;
  for (Time now{0}; now < 2 * FlightEnd::kMostLanding; now += kStep) {
    EXPECT_EQ(end.update(now, kFlies), Stage::kFlying);
    EXPECT_EQ(end.update(now, {.all_still = true}), Stage::kFlying);
  }
}

TEST(FlightEnd, BrakesThenLandsThenIsDone) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kMoves), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kMoves), Stage::kBraking);
  EXPECT_EQ(end.update(3 * kStep, kRests), Stage::kLanding);
  EXPECT_EQ(end.update(4 * kStep, kRests), Stage::kLanding);
  EXPECT_EQ(end.update(5 * kStep, kIsDown), Stage::kDone);
  EXPECT_EQ(end.update(6 * kStep, kFlies), Stage::kDone);
}

TEST(FlightEnd, EachStageIsThereForATickAtLeast) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kIsDown), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kIsDown), Stage::kLanding);
  EXPECT_EQ(end.update(3 * kStep, kIsDown), Stage::kDone);
}

TEST(FlightEnd, IsNotCalledOffByAPlannerThatChangesItsMind) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kMoves), Stage::kBraking);
  EXPECT_EQ(end.update(2 * kStep, kFlies), Stage::kBraking);
}

TEST(FlightEnd, NeitherBrakingNorLandingTakesForEver) {
  FlightEnd end;
  EXPECT_EQ(end.update(kStep, kMoves), Stage::kBraking);
  EXPECT_EQ(end.update(kStep + FlightEnd::kMostBraking, kMoves), Stage::kBraking);
  const Time landing = kStep + FlightEnd::kMostBraking + Time(1);
  EXPECT_EQ(end.update(landing, kMoves), Stage::kLanding);
  EXPECT_EQ(end.update(landing + FlightEnd::kMostLanding, kMoves), Stage::kLanding);
  EXPECT_EQ(end.update(landing + FlightEnd::kMostLanding + Time(1), kMoves), Stage::kDone);
}

}  // namespace
}  // namespace mayfly::link
