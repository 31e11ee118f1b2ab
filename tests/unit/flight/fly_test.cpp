// The loop of a flight, on robots that do exactly as they are told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Wants one velocity of everybody; or fails.
class ScriptedEngine final : public Engine {
 public:
  std::string_view name() const noexcept override { return "scripted"; }
  Result<void> prepare(std::span<const SwarmModel>, std::size_t) override { return {}; }
  TickCounts compute(const AgentColumns&, const TickTime&, const VelocityColumns& out) noexcept override {
    const bool fails = tick_ >= fails_from && tick_ < fails_before;
    ++tick_;
    fault_ = fails ? "the device was lost" : "";
    const glm::vec3 v = fails ? glm::vec3(0.0F) : wanted;
    std::fill(out.x.begin(), out.x.end(), v.x);
    std::fill(out.y.begin(), out.y.end(), v.y);
    std::fill(out.z.begin(), out.z.end(), v.z);
    return {moved, infeasible};
  }
  void move_stimuli(std::size_t, std::span<const glm::vec3>) noexcept override {}
  void replace_fields(std::size_t, const SwarmFields&) noexcept override {}
  std::string_view fault() const noexcept override { return fault_; }

  glm::vec3 wanted{0.0F, 1.0F, 0.0F};
  std::size_t moved = 0, infeasible = 0;
  std::uint64_t fails_from = 0, fails_before = 0;

 private:
  std::string_view fault_;
  std::uint64_t tick_ = 0;
};

class TickCounter final : public Observer {
 public:
  void on_tick(const TickView& view) noexcept override {
    in_order = in_order && view.tick == ticks && view.x.size() == view.command_x.size();
    last = view.time;
    ++ticks;
  }
  std::uint64_t ticks = 0;
  bool in_order = true;
  Time last{0};
};

TEST(Fly, TicksAtItsRateForItsDuration) {
  for (const auto& [rate, duration, ticks] :
       {std::tuple{100.0F, 0.2, 20U}, std::tuple{50.0F, 0.5, 25U}, std::tuple{200.0F, 0.005, 1U}}) {
    Scenario scenario = hall(3);
    scenario.control.rate = rate;
    scenario.duration = duration;
    Sortie sortie(std::move(scenario));
    const auto summary = sortie.fly();
    ASSERT_TRUE(summary) << to_string(summary.error());
    EXPECT_EQ(summary->ticks, ticks) << rate;
    EXPECT_NEAR(summary->simulated_s, duration, 1e-9) << rate;
    EXPECT_THAT(sortie.hal.written, SizeIs(ticks)) << rate;
    EXPECT_EQ(sortie.gauge.flown_ns.load(), from_seconds(summary->simulated_s).count()) << rate;
  }
}

TEST(Fly, SendsCommandsInSequenceWithADeadlineAhead) {
  Sortie sortie(hall(3));
  ASSERT_TRUE(sortie.fly());
  ASSERT_THAT(sortie.hal.written, SizeIs(20));
  std::uint64_t last = 0;
  for (const auto& tick : sortie.hal.written) {
    EXPECT_EQ(tick.sequence, last + 1);
    // One late tick must not stop a robot; a dead controller must, soon.
    EXPECT_GT(tick.deadline, tick.now + Time(std::chrono::milliseconds(20)));
    EXPECT_LE(tick.deadline, tick.now + Time(std::chrono::milliseconds(100)));
    last = tick.sequence;
  }
}

TEST(Fly, BringsEverybodyToTheGoal) {
  Scenario scenario = walled_hall(8);
  scenario.duration = 30;
  scenario.expect = {{Expectation::Quantity::kReached, "flies", "exit",
                      Expectation::Comparison::kGreaterEqual, 1.0, "reached"},
                     {Expectation::Quantity::kPenetrations, "", "", Expectation::Comparison::kEqual, 0.0, ""},
                     {Expectation::Quantity::kReached, "", "", Expectation::Comparison::kLess, 1.0, ""}};
  Sortie sortie(std::move(scenario));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_EQ(summary->reached_fraction, 1.0);
  EXPECT_EQ(summary->penetrations, 0U);
  EXPECT_EQ(summary->collisions, 0U);
  EXPECT_THAT(summary->faults, IsEmpty());
  ASSERT_THAT(summary->expect, SizeIs(3));
  EXPECT_TRUE(summary->expect[0].pass);
  EXPECT_TRUE(summary->expect[1].pass);
  EXPECT_FALSE(summary->expect[2].pass);
}

TEST(Fly, NamesWhatFlew) {
  Sortie sortie(hall(3));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->scenario, "hall");
  EXPECT_EQ(summary->engine, "native");
  EXPECT_EQ(summary->hal, "points");
  EXPECT_EQ(summary->seed, 5U);
  EXPECT_EQ(summary->agents, 3U);
  EXPECT_FALSE(summary->stopped_by_user);
  EXPECT_EQ(summary->control.jitter_us, std::nullopt) << "a virtual clock has none";
  EXPECT_EQ(sortie.hal.deactivated, 1);
}

TEST(Fly, ShowsEveryTickToWhoeverWatches) {
  Sortie sortie(hall(3));
  TickCounter counter;
  sortie.observers = {&counter};
  ASSERT_TRUE(sortie.fly());
  EXPECT_EQ(counter.ticks, 20U);
  EXPECT_TRUE(counter.in_order);
  EXPECT_EQ(counter.last, Time(std::chrono::milliseconds(190)));
}

Scenario hall_of_avoiders(int agents) {
  Scenario scenario = hall(agents);
  scenario.swarms[0].avoidance.on = true;
  return scenario;
}

TEST(Fly, SaysOnceWhenEveryAgentIsInfeasible) {
  Sortie sortie(hall_of_avoiders(4));
  ScriptedEngine engine;
  engine.infeasible = 4;
  const auto summary = sortie.fly_with(sortie.hal, engine);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->infeasible_agents, 80U);
  EXPECT_EQ(summary->all_infeasible_s, 0.0);
  ASSERT_THAT(summary->faults, SizeIs(1));
  EXPECT_THAT(summary->faults[0].cause, HasSubstr("every agent infeasible"));
}

TEST(Fly, CountsInfeasibleAgentsWithoutAlarmWhileSomebodyHasAWay) {
  Sortie sortie(hall_of_avoiders(4));
  ScriptedEngine engine;
  engine.infeasible = 3;
  const auto summary = sortie.fly_with(sortie.hal, engine);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->infeasible_agents, 60U);
  EXPECT_EQ(summary->all_infeasible_s, std::nullopt);
  EXPECT_THAT(summary->faults, IsEmpty());
}

TEST(Fly, WhereNobodyAvoidsInfeasibleAgentsAreNotMeasured) {
  Sortie sortie(hall(4));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->infeasible_agents, std::nullopt);
}

TEST(Fly, CountsTheShareOfAgentsThatMdeMoved) {
  Sortie sortie(hall(4));
  ScriptedEngine engine;
  engine.moved = 1;
  const auto summary = sortie.fly_with(sortie.hal, engine);
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->mde_percent, 25.0);
}

TEST(Fly, DidNotMeasureMdeWhereThereIsNone) {
  Scenario scenario = hall(4);
  scenario.swarms[0].mde_sweeps = 0;
  Sortie sortie(std::move(scenario));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  EXPECT_EQ(summary->mde_percent, std::nullopt);
}

TEST(Fly, RefusesAHalWithAnotherNumberOfRobots) {
  Sortie sortie(hall(3));
  PointHal two({{3, 3, 3}, {5, 3, 3}});
  const auto summary = sortie.fly_with(two, *sortie.engine);
  ASSERT_FALSE(summary);
  EXPECT_THAT(summary.error().message, HasSubstr("2 robots"));
  EXPECT_THAT(summary.error().message, HasSubstr("3 agents"));
  EXPECT_THAT(two.written, IsEmpty());
  EXPECT_NE(two.state(), HalState::kActive);
}

TEST(Fly, PassesOnWhyAHalRefuses) {
  for (const auto& [flag, text] : {std::pair{&PointHal::configure_fails, "no such dongle"},
                                   std::pair{&PointHal::activate_fails, "rotors are off"},
                                   std::pair{&PointHal::deactivate_fails, "won't land"}}) {
    Sortie sortie(hall(3));
    sortie.hal.*flag = true;
    const auto summary = sortie.fly();
    ASSERT_FALSE(summary) << text;
    EXPECT_EQ(summary.error().message, text);
    EXPECT_EQ(summary.error().cause, Cause::kDevice);
    EXPECT_EQ(sortie.hal.written.empty(), flag != &PointHal::deactivate_fails) << text;
  }
}

TEST(Fly, HoldsARobotThatIsNeverHeardWhileTheOthersFlyOn) {
  Scenario scenario = hall(6);
  scenario.duration = 20;
  Sortie sortie(std::move(scenario));
  sortie.hal.silent = {2};
  const glm::vec3 start = sortie.hal.places()[2];
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  for (const auto& tick : sortie.hal.written) {
    ASSERT_EQ(tick.kinds[2], CommandKind::kHold);
    ASSERT_EQ(tick.kinds[3], CommandKind::kVelocity);
  }
  EXPECT_EQ(sortie.hal.places()[2], start);
  EXPECT_NEAR(summary->reached_fraction.value_or(-1), 5.0 / 6.0, 1e-9);
}

// Two robots that get in each other's way part, though a third one has no place in the same eight lanes.
TEST(Fly, PartsRobotsBesideOneThatIsNeverHeard) {
  Scenario scenario = hall(3);
  scenario.duration = 2;
  Sortie sortie(std::move(scenario));
  PointHal hal({{6, 3, 6}, {6.05F, 3, 6}, {1, 1, 1}});
  hal.silent = {2};
  ASSERT_TRUE(sortie.fly_with(hal, *sortie.engine));
  EXPECT_GT(glm::distance(hal.places()[0], hal.places()[1]), 0.15F);
  EXPECT_GT(hal.places()[0].y, 3.5F);
  EXPECT_GT(hal.places()[1].y, 3.5F);
}

TEST(Fly, HoldsARobotThatClaimsANaNAndNamesIt) {
  Sortie sortie(hall(4));
  sortie.hal.lying = {1};
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  for (const auto& tick : sortie.hal.written) {
    EXPECT_EQ(tick.kinds[1], CommandKind::kHold);
    EXPECT_EQ(tick.kinds[0], CommandKind::kVelocity);
  }
  ASSERT_THAT(summary->faults, SizeIs(1)) << "one fault that goes on is one event";
  EXPECT_EQ(summary->faults[0].robot, "point_1");
  EXPECT_EQ(summary->faults[0].link, "wire");
  EXPECT_EQ(summary->faults[0].time_s, 0.0);
  EXPECT_THAT(summary->faults[0].cause, HasSubstr("not a number"));
  EXPECT_EQ(sortie.gauge.faults.load(), 1U);
}

TEST(Fly, TellsOnceOfAReadThatGoesOnFailingAndFliesOn) {
  Sortie sortie(hall(4));
  sortie.hal.read_result = {HalFault::kRobotSilent, 3, "wire", "no answer"};
  sortie.hal.read_fails_from = 5;
  sortie.hal.read_fails_before = 12;
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  ASSERT_THAT(summary->faults, SizeIs(1));
  EXPECT_EQ(summary->faults[0].robot, "point_3");
  EXPECT_NEAR(summary->faults[0].time_s, 0.05, 1e-9);
  EXPECT_EQ(summary->faults[0].cause, "no answer");
  EXPECT_EQ(summary->ticks, 20U);
  EXPECT_THAT(sortie.hal.written.back().kinds, Each(CommandKind::kVelocity));
}

TEST(Fly, TellsOfAWriteThatFails) {
  Sortie sortie(hall(4));
  sortie.hal.write_result = {HalFault::kLinkDown, kEveryRobot, "wire", "bus off"};
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary);
  const auto& faults = summary->faults;
  const auto told = [&](std::string_view cause) {
    return std::count_if(faults.begin(), faults.end(), [&](const FaultEvent& fault) {
      return fault.cause.find(cause) != std::string::npos;
    });
  };
  EXPECT_EQ(told("bus off"), 1) << "one fault that goes on is one event";
  EXPECT_EQ(faults[0].cause, "bus off");
  EXPECT_EQ(faults[0].robot, "");
  EXPECT_EQ(faults[0].severity, "") << "what the HAL says";
  EXPECT_GT(told("link does not answer"), 0) << "what the guard makes of it";
  EXPECT_EQ(summary->safety.severity_max, "hold_all");
  EXPECT_THAT(sortie.hal.written.back().velocities, Each(glm::vec3(0.0F)));
}

TEST(Fly, StopsEverybodyWhileTheEngineFailsAndGoesOnAfterwards) {
  Scenario scenario = hall(4);
  scenario.swarms[0].governor = false;  // which would brake gently
  Sortie sortie(std::move(scenario));
  ScriptedEngine engine;
  engine.fails_from = 8;
  engine.fails_before = 11;
  const auto summary = sortie.fly_with(sortie.hal, engine);
  ASSERT_TRUE(summary);
  ASSERT_THAT(summary->faults, SizeIs(1));
  EXPECT_EQ(summary->faults[0].cause, "the device was lost");
  EXPECT_EQ(summary->faults[0].link, "scripted");
  EXPECT_NEAR(summary->faults[0].time_s, 0.08, 1e-9);
  EXPECT_THAT(sortie.hal.written[7].velocities, Each(engine.wanted));
  EXPECT_THAT(sortie.hal.written[8].velocities, Each(glm::vec3(0.0F)));
  EXPECT_THAT(sortie.hal.written[10].velocities, Each(glm::vec3(0.0F)));
  EXPECT_THAT(sortie.hal.written[11].velocities, Each(engine.wanted));
}

TEST(Fly, KeepsTheLimitsWhateverTheEngineWants) {
  Scenario scenario = hall(4);
  scenario.duration = 10;
  Sortie sortie(std::move(scenario));
  ScriptedEngine engine;
  engine.wanted = {0.0F, 1e6F, 0.0F};
  const auto summary = sortie.fly_with(sortie.hal, engine);
  ASSERT_TRUE(summary);
  EXPECT_LE(summary->max_speed_mps.value_or(1e9), 3.0 * (1 + 1e-5));
  EXPECT_LE(summary->max_acceleration_mps2.value_or(1e9), 20.0 * (1 + 1e-3));
  EXPECT_GT(summary->governor_interventions, 0U);
  for (const glm::vec3 p : sortie.hal.places()) {
    EXPECT_LE(p.y, 20.0F - 0.05F) << "the fence";
    EXPECT_GT(p.y, 18.0F) << "it did not fly";
  }
}

TEST(Fly, HoldsWhereTheEngineWantsNoNumber) {
  Sortie sortie(hall(4));
  ScriptedEngine engine;
  engine.wanted = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  ASSERT_TRUE(sortie.fly_with(sortie.hal, engine));
  for (const auto& tick : sortie.hal.written) {
    EXPECT_THAT(tick.velocities, Each(glm::vec3(0.0F)));
  }
}

TEST(Fly, MayBeOfNobody) {
  Sortie sortie(hall(0));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_EQ(summary->ticks, 20U);
  EXPECT_EQ(summary->reached_fraction, std::nullopt);
  EXPECT_EQ(summary->ns_per_agent_tick, std::nullopt);
}

}  // namespace
}  // namespace mayfly::test
