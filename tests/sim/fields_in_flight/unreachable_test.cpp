// A goal that goes out of reach: an error before the flight, an event during it.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/sim/fields_in_flight/worlds.hpp"

namespace mayfly::test {
namespace {

TEST(Unreachable, ADoorThatClosesIsAnEventAndTheSwarmFliesOnWhenItOpens) {
  const Summary summary = flown(door(20, 40, true));
  ASSERT_EQ(summary.faults.size(), 1U);
  EXPECT_NE(summary.faults[0].cause.find("goal 'exit'"), std::string::npos) << summary.faults[0].cause;
  EXPECT_EQ(summary.faults[0].link, "fields");
  EXPECT_GT(summary.faults[0].time_s, 2.0);
  EXPECT_LT(summary.faults[0].time_s, 9.0);
  EXPECT_EQ(summary.fields->unreachable, 1U);
  EXPECT_EQ(summary.reached_fraction, 1.0);
  EXPECT_EQ(summary.penetrations, 0U);
}

TEST(Unreachable, BehindADoorThatStaysClosedTheSwarmHolds) {
  class Extent final : public Observer {
   public:
    void on_tick(const TickView& view) noexcept override {
      for (std::size_t a = 0; to_seconds(view.time) > 15 && a < view.x.size(); ++a) {
        fastest = std::max(fastest, std::hypot(view.vx[a], view.vy[a], view.vz[a]));
      }
    }
    float fastest = 0;
  } extent;
  const std::array<Observer*, 1> observers{&extent};
  Scenario scenario = door(20, 25, false);
  scenario.swarms[0].cruise_speed = 0.5F;  // nobody is through when it closes
  const Summary summary = flown(scenario, {.threads = 1, .observers = observers});
  EXPECT_EQ(summary.fields->unreachable, 1U);
  EXPECT_EQ(summary.reached_fraction, 0.0);
  EXPECT_EQ(summary.penetrations, 0U);
  EXPECT_LT(extent.fastest, 0.05F) << "m/s, of whoever has no way";
}

TEST(Unreachable, ACoveredGoalIsAnEvent) {
  Scenario scenario = hall_with(
      "{box: {min: [20, 4, -12], max: [29, 16, -1]}, path: {points: [[24, 10, -6], [24, 10, 6]], speed: "
      "1.5}}",
      "exit: {box: {min: [22, 7, 3], max: [26, 13, 8]}}",
      "count: 10, start: {box: {min: [1, 4, 2], max: [4, 16, 10]}}, goal: exit", 12);
  const Summary summary = flown(scenario);
  ASSERT_EQ(summary.faults.size(), 1U);
  EXPECT_NE(summary.faults[0].cause.find("goal 'exit'"), std::string::npos);
  EXPECT_EQ(summary.penetrations, 0U);
}

TEST(Unreachable, IsAnErrorBeforeTheFlight) {
  Scenario scenario = door(5, 5, true);
  // Closed from the start on.
  scenario.world.obstacles[2].shape = fields::BoxShape{{{12, 7, 0}, {15, 13, 12}}};
  const auto refused = simulate::fly_simulated(scenario);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error()[0].message.find("no free path"), std::string::npos) << refused.error()[0].message;
}

}  // namespace
}  // namespace mayfly::test
