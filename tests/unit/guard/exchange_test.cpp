// Where a robot stands that was taken out of the run, all keep clear of it but the one that flies in its
// stead; and robots that are led somewhere, or return.
#include "controller/guard/exchange.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/unit/guard/field_trip.hpp"

namespace mayfly::test {
namespace {

// m: two bodies and their tubes; a little more is kept for what happens between ticks.
constexpr float kKept = 0.3F;
constexpr float kMore = 0.03F;

class Spot final : public Exchange {
 public:
  void tick(Time, Guard&) noexcept override { ++ticks; }
  std::span<const KeptClear> kept_clear() noexcept override { return places; }

  std::vector<KeptClear> places;
  int ticks = 0;
};

GuardConfig with(Spot& spot, std::size_t robots) {
  GuardConfig config = guard_of(robots);
  config.exchange = &spot;
  return config;
}

TEST(KeptClear, OthersStopBeforeIt) {
  Spot spot;
  spot.places = {{{8, 10, 10}, {8, 10, 10}, 1}};
  FieldTrip trip({{5, 10, 10}, {5, 14, 10}}, with(spot, 2));
  trip.wish = WishOf(2, {2, 0, 0});
  trip.fly(5);
  EXPECT_LE(trip.robots.at[0].x, 8.0F - kKept);
  EXPECT_GE(trip.robots.at[0].x, 8.0F - kKept - 0.1F) << "no farther off than need be";
  EXPECT_EQ(trip.severity(0), Severity::kNone);
  EXPECT_GT(trip.robots.at[1].x, 14.0F) << "nobody is in its way";
  EXPECT_EQ(spot.ticks, 500);
}

TEST(KeptClear, WhoFliesInItsSteadMayBeThere) {
  Spot spot;
  spot.places = {{{8, 10, 10}, {8, 10, 10}, 0}};
  FieldTrip trip({{5, 10, 10}, {5, 14, 10}}, with(spot, 2));
  trip.wish = WishOf(2, {2, 0, 0});
  trip.fly(5);
  EXPECT_GT(trip.robots.at[0].x, 14.0F);
}

TEST(KeptClear, OneThatPassesFarEnoughIsNotHeldUp) {
  Spot spot;
  spot.places = {{{8, 10 + kKept + kMore, 10}, {8, 10 + kKept + kMore, 10}, 1}};
  FieldTrip trip({{5, 10, 10}, {5, 14, 10}}, with(spot, 2));
  trip.wish = WishOf(2, {2, 0, 0});
  trip.fly(5);
  EXPECT_GT(trip.robots.at[0].x, 14.0F);
  spot.places[0].from.y = spot.places[0].to.y = 10 + kKept - kMore;
  FieldTrip nearer({{5, 10, 10}, {5, 14, 10}}, with(spot, 2));
  nearer.wish = WishOf(2, {2, 0, 0});
  nearer.fly(5);
  EXPECT_LT(nearer.robots.at[0].x, 8.0F);
}

TEST(KeptClear, TheWayToItsRestCounts) {
  Spot spot;
  spot.places = {{{8, 12, 10}, {8, 10, 10}, 1}};
  FieldTrip trip({{5, 10, 10}, {5, 16, 10}}, with(spot, 2));
  trip.wish = WishOf(2, {2, 0, 0});
  trip.fly(5);
  EXPECT_LT(trip.robots.at[0].x, 8.0F - kKept);
}

TEST(KeptClear, OneThatIsTooNearMayLeave) {
  Spot spot;
  FieldTrip trip({{8, 10, 10}, {5, 14, 10}}, with(spot, 2));
  trip.fly(1);
  spot.places = {{{8.2F, 10, 10}, {8.2F, 10, 10}, 1}};
  trip.wish = WishOf(2, {-1, 0, 0});
  trip.fly(1);
  EXPECT_LT(trip.robots.at[0].x, 7.5F);
}

TEST(KeptClear, ARobotThatThereIsNotIsNobodys) {
  Spot spot;
  spot.places = {{{8, 10, 10}, {8, 10, 10}, 9}};
  FieldTrip trip({{5, 10, 10}}, with(spot, 1));
  trip.wish = WishOf(1, {2, 0, 0});
  trip.fly(5);
  EXPECT_GT(trip.robots.at[0].x, 14.0F);
}

TEST(Lead, GoesToThePlaceHoldsThereAndGoesOnWhenItIsGivenBack) {
  FieldTrip trip({{5, 10, 10}, {5, 14, 10}});
  trip.wish = WishOf(2, {1, 0, 0});
  trip.fly(1);
  EXPECT_TRUE(trip.guard->lead(0, {5, 10, 12}));
  EXPECT_FALSE(trip.guard->lead(0, {5, 10, 12})) << "it is on its way";
  trip.fly(12);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kHolding);
  EXPECT_LT(glm::distance(trip.robots.at[0], glm::vec3(5, 10, 12)), 0.03F);
  EXPECT_TRUE(trip.guard->request(0, RobotEvent::kResume));
  const float x = trip.robots.at[0].x;
  trip.fly(2);
  EXPECT_GT(trip.robots.at[0].x, x + 1.0F);
}

TEST(Return, GoesBackToWhereItStartedAndLandsThere) {
  FieldTrip trip({{5, 10, 3}, {5, 14, 3}});
  trip.wish = WishOf(2, {1, 0, 0});
  trip.fly(3);
  EXPECT_TRUE(trip.guard->request(0, RobotEvent::kReturn));
  trip.fly(0.1);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kReturning);
  trip.fly(15);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kLanding);
  EXPECT_NEAR(trip.robots.at[0].x, 5.0F, 0.05F);
  EXPECT_NEAR(trip.robots.at[0].y, 10.0F, 0.05F);
  EXPECT_GT(trip.robots.at[1].x, 12.0F) << "the other flies on";
}

// Somebody is in the way: it waits, and goes on when that one has gone.
TEST(Return, WaitsForWhoeverIsInItsWay) {
  FieldTrip trip({{5, 10, 10}, {9, 10, 10}});
  trip.wish = WishOf(2, {0, 0, 0});
  trip.wish.vx[0] = 0.0F;
  trip.fly(0.1);
  // Up, over and behind the other.
  for (const glm::vec3 way : {glm::vec3(0, 0, 1), glm::vec3(2, 0, 0), glm::vec3(0, 0, -1)}) {
    trip.wish.vx[0] = way.x;
    trip.wish.vz[0] = way.z;
    trip.fly(4);
    trip.wish.vx[0] = trip.wish.vz[0] = 0.0F;
    trip.fly(1);
  }
  ASSERT_GT(trip.robots.at[0].x, 10.0F);
  EXPECT_TRUE(trip.guard->request(0, RobotEvent::kReturn));
  trip.fly(20);
  EXPECT_EQ(trip.guard->states()[0], RobotState::kReturning);
  EXPECT_GT(trip.robots.at[0].x, 9.0F + kKept);
  trip.wish.vy[1] = 1.0F;
  trip.fly(2);
  trip.wish.vy[1] = 0.0F;
  trip.fly(30);
  EXPECT_NEAR(trip.robots.at[0].x, 5.0F, 0.05F);
}

}  // namespace
}  // namespace mayfly::test
