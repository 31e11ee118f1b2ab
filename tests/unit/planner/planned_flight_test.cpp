// Flights whose model runs beside control, on the virtual clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

// All that was seen and told, bit for bit.
class Tape final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    for (const auto column : {view.x, view.y, view.z, view.command_x, view.command_y, view.command_z}) {
      all.insert(all.end(), column.begin(), column.end());
    }
    commands.push_back(view.command_y[0]);
  }
  std::vector<float> all;
  std::vector<float> commands;  // of the first agent, along y
};

Scenario across(std::vector<PlannerSpec> planners, double duration = 20.0) {
  Scenario scenario = walled_hall(12);
  scenario.duration = duration;
  scenario.swarms[0].governor = false;
  scenario.planners = std::move(planners);
  return scenario;
}

struct Flown {
  Summary summary;
  Tape tape;
};

Flown fly(const Scenario& scenario) {
  Flown flown;
  Sortie sortie(scenario);
  sortie.observers = {&flown.tape};
  auto summary = sortie.fly();
  if (!summary) {
    ADD_FAILURE() << to_string(summary.error());
    return flown;
  }
  flown.summary = std::move(*summary);
  return flown;
}

// How many ticks in a row told the first agent the same, from tick 20 to 120.
std::vector<int> runs_of_equal_commands(const Tape& tape) {
  std::vector<int> runs{1};
  for (std::size_t tick = 21; tick < 120; ++tick) {
    if (tape.commands[tick] == tape.commands[tick - 1]) {
      ++runs.back();
    } else {
      runs.push_back(1);
    }
  }
  return runs;
}

TEST(PlannedFlight, AtControlsRateWithoutLatencyItGivesTheSameBitsAsInTheTick) {
  const Flown in_tick = fly(across({}));
  const Flown beside = fly(across({{"curl_noise", 100.0F, 0.0F, {}}}));
  EXPECT_EQ(in_tick.tape.all, beside.tape.all);
  EXPECT_EQ(in_tick.summary.min_separation_m, beside.summary.min_separation_m);
  EXPECT_EQ(in_tick.summary.mde_percent, beside.summary.mde_percent);
  EXPECT_TRUE(in_tick.summary.control.ages.empty());
  ASSERT_EQ(beside.summary.control.tasks.size(), 2U);
  EXPECT_EQ(beside.summary.control.tasks[1].ticks, beside.summary.control.ticks);
}

TEST(PlannedFlight, ASlowerPlannerIsFlownForSeveralTicks) {
  const Flown flown = fly(across({{"curl_noise", 20.0F, {}, {}}}, 30.0));
  EXPECT_EQ(flown.summary.reached_fraction, 1.0);
  EXPECT_EQ(flown.summary.penetrations, 0U);
  EXPECT_TRUE(flown.summary.faults.empty());
  const std::vector<int> runs = runs_of_equal_commands(flown.tape);
  EXPECT_TRUE(std::all_of(runs.begin() + 1, runs.end() - 1, [](int run) { return run == 5; }));
  const AgeSummary& plan = flown.summary.control.ages[1];
  EXPECT_EQ(plan.expired, 0U);
  EXPECT_DOUBLE_EQ(plan.limit_s, 0.15);
  EXPECT_NEAR(plan.age_s->max, 0.09, 1e-9);  // a latency of 50 ms, then flown for five ticks
  EXPECT_NEAR(plan.age_s->p50, 0.07, 0.001);
}

TEST(PlannedFlight, AFasterPlannerAsWell) {
  const Flown flown = fly(across({{"curl_noise", 250.0F, {}, {}}}, 30.0));
  EXPECT_EQ(flown.summary.reached_fraction, 1.0);
  EXPECT_TRUE(flown.summary.faults.empty());
  EXPECT_EQ(flown.summary.control.tasks[1].ticks, 30U * 250U);
  EXPECT_EQ(flown.summary.control.ages[1].expired, 0U);
  EXPECT_EQ(flown.summary.control.ages[0].expired, 0U);
}

TEST(PlannedFlight, RatesNeedNotDivideAndARunRepeatsBitForBit) {
  const Scenario scenario = across({{"curl_noise", 33.0F, 0.013F, {}}}, 10.0);
  const Flown first = fly(scenario);
  const Flown second = fly(scenario);
  EXPECT_EQ(first.tape.all, second.tape.all);
  EXPECT_EQ(first.summary.control.tasks[1].ticks, 331U);  // 30 303 030 ns: release 330 is at 9.9999999 s
  EXPECT_TRUE(first.summary.faults.empty());
}

TEST(PlannedFlight, UntilTheFirstPlanIsThereEverybodyStands) {
  const Flown flown = fly(across({{"curl_noise", 20.0F, {}, {}}}, 1.0));
  for (std::size_t tick = 0; tick < 5; ++tick) {
    EXPECT_EQ(flown.tape.commands[tick], 0.0F) << tick;
  }
  EXPECT_NE(flown.tape.commands[5], 0.0F);
}

}  // namespace
}  // namespace mayfly::test
