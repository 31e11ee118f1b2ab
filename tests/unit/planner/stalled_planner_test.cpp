// A planner that stalls, on the real clock: robots brake and stand, and fly on when it is back. Nothing here
// depends on how fast the machine is: each step waits for the one before to be seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "controller/clock/realtime_clock.hpp"
#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

// Far beyond what the test takes; only so that it ends where something is broken.
constexpr std::uint64_t kMostTicks = 3000;

// Everybody flies along y, until the third plan does not come back before it is told to.
class StallingEngine final : public Engine {
 public:
  std::string_view name() const noexcept override { return "stalling"; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override { return {}; }
  TickCounts compute(const AgentColumns&, const TickTime&, const VelocityColumns& out) noexcept override {
    if (++plans == 3) {
      while (!go_on.load()) {
        std::this_thread::yield();
      }
    }
    std::fill(out.x.begin(), out.x.end(), 0.0F);
    std::fill(out.y.begin(), out.y.end(), 0.5F);
    std::fill(out.z.begin(), out.z.end(), 0.0F);
    return {};
  }
  void move_stimuli(std::size_t, std::span<const glm::vec3>) noexcept override {}
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}

  std::atomic<int> plans{0};
  std::atomic<bool> go_on{false};
};

// Sees them fly, sees them stand, lets the planner go on, sees them fly again, and ends the flight.
class Witnesses final : public Observer {
 public:
  Witnesses(StallingEngine& engine, StopRequest& stop) : engine_(engine), stop_(stop) {}
  void on_tick(const TickView& view) noexcept override {
    const bool flies = std::abs(view.command_y[0]) > 0.1F;
    const bool stands = view.command_y[0] == 0.0F && view.vy[0] == 0.0F;
    if (step == 0 && flies && engine_.plans >= 3) {
      step = 1;
    } else if (step == 1 && stands) {
      step = 2;
      engine_.go_on = true;
    } else if (step == 2 && flies) {
      step = 3;
      stop_ = 1;
    }
    if (view.tick > kMostTicks) {
      engine_.go_on = true;
      stop_ = 1;
    }
  }
  int step = 0;

 private:
  StallingEngine& engine_;
  StopRequest& stop_;
};

TEST(StalledPlanner, EverybodyBrakesAndStandsAndFliesOnWhenItIsBack) {
  Scenario scenario = hall(3);
  scenario.duration = 60;
  scenario.planners = {{"curl_noise", 50.0F, {}, {}}};
  Sortie sortie(scenario);
  StallingEngine engine;
  Witnesses witnesses(engine, sortie.stop);
  const std::vector<Observer*> watching{&witnesses};
  RealtimeClock clock;
  auto flown = fly({.scenario = sortie.scenario,
                    .world = sortie.world,
                    .engine = engine,
                    .hal = sortie.hal,
                    .clock = clock,
                    .observers = watching,
                    .stop = &sortie.stop});
  ASSERT_TRUE(flown) << to_string(flown.error());
  EXPECT_EQ(witnesses.step, 3);
  EXPECT_GT(flown->control.ages[1].expired, 0U);
  EXPECT_GT(flown->control.ages[1].age_s->max, flown->control.ages[1].limit_s);
  std::vector<std::string> links;
  for (const FaultEvent& fault : flown->faults) {
    links.push_back(fault.link);
  }
  EXPECT_THAT(links, testing::Contains("curl_noise"));
  EXPECT_GE(flown->control.tasks[1].ticks, 4U);
}

TEST(PlannedInRealTime, FliesAndTellsOfBothTasks) {
  Scenario scenario = hall(5);
  scenario.duration = 0.3;
  scenario.planners = {{"curl_noise", 50.0F, {}, {}}};
  Sortie sortie(scenario);
  RealtimeClock clock;
  auto flown = fly({.scenario = sortie.scenario,
                    .world = sortie.world,
                    .engine = *sortie.engine,
                    .hal = sortie.hal,
                    .clock = clock});
  ASSERT_TRUE(flown) << to_string(flown.error());
  ASSERT_EQ(flown->control.tasks.size(), 2U);
  EXPECT_EQ(flown->control.tasks[0].thread, "control");
  EXPECT_EQ(flown->control.tasks[1].thread, "own");
  EXPECT_EQ(flown->control.tasks[1].name, "curl_noise");
  EXPECT_NE(flown->control.realtime, "virtual");
}

}  // namespace
}  // namespace mayfly::test
