#include "controller/executor/executor.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/virtual_clock.hpp"
#include "core/armed_tick.hpp"
#include "tests/reference/allocation_count.hpp"
#include "tests/unit/executor/scripted_clock.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;

const std::atomic<bool> kNeverStop{false};

TEST(Executor, ReleasesOnTheGridWithoutDrift) {
  VirtualClock clock;
  Executor executor(clock);
  std::vector<Time> times;
  times.reserve(10000);
  ASSERT_TRUE(executor.add_task("control", 30.0, [&](const TickInfo& tick) noexcept {
    EXPECT_EQ(tick.release, times.size());
    EXPECT_EQ(tick.started, tick.scheduled);
    EXPECT_EQ(clock.now(), tick.started);
    times.push_back(tick.started);
  }));
  executor.run(100s, kNeverStop);
  ASSERT_EQ(times.size(), 3001U);  // 33 333 333 ns: release 3 000 is at 99.999999 s
  for (std::size_t k = 0; k < times.size(); ++k) {
    ASSERT_EQ(times[k], Time(33333333 * static_cast<std::int64_t>(k)));
  }
  EXPECT_EQ(clock.now(), 100s);
}

TEST(Executor, AVirtualRunHasNoJitterButARunTime) {
  VirtualClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [](const TickInfo&) noexcept {}));
  executor.run(40s, kNeverStop);
  const TaskStats stats = executor.stats().at(0);
  EXPECT_EQ(stats.ticks, 4000U);
  EXPECT_EQ(stats.rate_hz, 100.0);
  EXPECT_EQ(stats.missed, 0U);
  EXPECT_EQ(stats.jitter->max, 0.0);
  EXPECT_GT(stats.run->max, 0.0);
}

TEST(Executor, NoTaskAndNoTick) {
  VirtualClock clock;
  Executor executor(clock);
  executor.run(1s, kNeverStop);
  EXPECT_EQ(clock.now(), 1s);
  ASSERT_TRUE(executor.add_task("late", 1.0, [](const TickInfo&) noexcept {}));
  executor.run(0s, kNeverStop);
  EXPECT_EQ(executor.stats()[0].ticks, 0U);
  EXPECT_FALSE(executor.stats()[0].jitter.has_value());  // not measured is not 0
}

TEST(Executor, RefusesRatesThatMakeNoSenseAndNamesTwice) {
  VirtualClock clock;
  Executor executor(clock);
  const auto nothing = [](const TickInfo&) noexcept {};
  for (const double rate : {0.0, -1.0, 1e-4, 2e5, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    const auto added = executor.add_task("control", rate, nothing);
    ASSERT_FALSE(added) << rate;
    EXPECT_EQ(added.error().cause, Cause::kCaller);
  }
  EXPECT_TRUE(executor.add_task("control", 1e-3, nothing));
  EXPECT_FALSE(executor.add_task("control", 1.0, nothing));
}

TEST(Executor, RatesNeedNotDivideAndTheEarliestDeadlineGoesFirst) {
  VirtualClock clock;
  Executor executor(clock);
  std::string order;
  ASSERT_TRUE(executor.add_task("slow", 3.0, [&](const TickInfo&) noexcept { order += 's'; }));
  ASSERT_TRUE(executor.add_task("fast", 5.0, [&](const TickInfo&) noexcept { order += 'f'; }));
  executor.run(999ms, kNeverStop);
  // fast at 0 0.2 0.4 0.6 0.8; slow at 0 0.333 0.667
  EXPECT_EQ(order, "fsfsffsf");
}

TEST(Executor, EqualDeadlinesKeepTheOrderOfAdding) {
  VirtualClock clock;
  Executor executor(clock);
  std::string order;
  ASSERT_TRUE(executor.add_task("a", 10.0, [&](const TickInfo&) noexcept { order += 'a'; }));
  ASSERT_TRUE(executor.add_task("b", 10.0, [&](const TickInfo&) noexcept { order += 'b'; }));
  executor.run(250ms, kNeverStop);
  EXPECT_EQ(order, "ababab");
}

TEST(Executor, WorkThatIsJustInTimeMissesNothing) {
  ScriptedClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo&) noexcept { clock.work(10ms); }));
  executor.run(1s, kNeverStop);
  EXPECT_EQ(executor.stats()[0].ticks, 100U);
  EXPECT_EQ(executor.stats()[0].missed, 0U);
}

TEST(Executor, WorkOneNanosecondTooLongIsOurMiss) {
  ScriptedClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo& tick) noexcept {
    clock.work(tick.release == 3 ? 10ms + 1ns : 1ms);
  }));
  executor.run(1s, kNeverStop);
  const TaskStats stats = executor.stats()[0];
  EXPECT_EQ(stats.ticks, 100U);  // release 4 started a nanosecond late, and was in time
  EXPECT_EQ(stats.missed, 1U);
  EXPECT_EQ(stats.missed_by_machine, 0U);
  EXPECT_EQ(stats.skipped, 0U);
  EXPECT_DOUBLE_EQ(stats.jitter->max, 1e-3);
}

TEST(Executor, AnOverrunSkipsAndNeverBursts) {
  ScriptedClock clock;
  Executor executor(clock);
  std::vector<std::uint64_t> releases;
  std::vector<std::uint64_t> skipped;
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo& tick) noexcept {
    releases.push_back(tick.release);
    skipped.push_back(tick.skipped);
    clock.work(tick.release == 2 ? 35ms : 1ms);
  }));
  executor.run(100ms, kNeverStop);
  // Release 2 is at 20 ms and ends at 55: 3 and 4 are lost, 5 is 5 ms late.
  EXPECT_EQ(releases, (std::vector<std::uint64_t>{0, 1, 2, 5, 6, 7, 8, 9}));
  EXPECT_EQ(skipped, (std::vector<std::uint64_t>{0, 0, 0, 2, 0, 0, 0, 0}));
  const TaskStats stats = executor.stats()[0];
  EXPECT_EQ(stats.missed, 3U);  // 2 ended late, 3 and 4 never ran
  EXPECT_EQ(stats.skipped, 2U);
  EXPECT_EQ(stats.missed_by_machine, 0U);
  EXPECT_EQ(stats.ticks + stats.skipped, 10U);
}

TEST(Executor, ALateWakeUpIsTheMachines) {
  ScriptedClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo& tick) noexcept {
    clock.work(1ms);
    if (tick.release == 2) {
      clock.oversleep = 25ms;  // asked for 30 ms, woken at 55
    }
  }));
  executor.run(100ms, kNeverStop);
  const TaskStats stats = executor.stats()[0];
  EXPECT_EQ(stats.ticks, 8U);
  EXPECT_EQ(stats.missed, 2U);  // 3 and 4
  EXPECT_EQ(stats.skipped, 2U);
  EXPECT_EQ(stats.missed_by_machine, 2U);
  EXPECT_DOUBLE_EQ(stats.jitter->max, 5000.0);
}

TEST(Executor, ALateWakeUpWithinThePeriodIsTheMachinesOnlyIfOurWorkWouldHaveFit) {
  for (const bool would_fit : {true, false}) {
    ScriptedClock clock;
    Executor executor(clock);
    ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo& tick) noexcept {
      clock.work(tick.release == 3 ? (would_fit ? 10ms : 10ms + 1ns) : 1ms);
      if (tick.release == 2) {
        clock.oversleep = 4ms;
      }
    }));
    executor.run(100ms, kNeverStop);
    const TaskStats stats = executor.stats()[0];
    EXPECT_EQ(stats.ticks, 10U);
    EXPECT_EQ(stats.missed, 1U);
    EXPECT_EQ(stats.missed_by_machine, would_fit ? 1U : 0U);
  }
}

TEST(Executor, AnotherTasksLongWorkIsOursThoughTheWakeUpWasLateToo) {
  ScriptedClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo&) noexcept {}));
  ASSERT_TRUE(executor.add_task(
      "record", 10.0, [&](const TickInfo& tick) noexcept { clock.work(tick.release == 0 ? 25ms : 0ms); }));
  executor.run(100ms, kNeverStop);
  const TaskStats control = executor.stats()[0];
  EXPECT_EQ(control.skipped, 1U);  // release 1, from 10 to 20 ms; release 2 is 5 ms late
  EXPECT_EQ(control.missed, 1U);
  EXPECT_EQ(control.missed_by_machine, 0U);
  EXPECT_EQ(executor.stats()[1].missed, 0U);
}

TEST(Executor, AYearOfSleepIsSkippedAndCounted) {
  ScriptedClock clock;
  Executor executor(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo&) noexcept { clock.oversleep = 1h; }));
  executor.run(2h, kNeverStop);
  const TaskStats stats = executor.stats()[0];
  EXPECT_EQ(stats.ticks + stats.skipped, 720000U);
  EXPECT_EQ(stats.missed, stats.missed_by_machine);
  EXPECT_LE(stats.ticks, 3U);
}

TEST(Executor, StopsBeforeTheNextTask) {
  VirtualClock clock;
  Executor executor(clock);
  std::atomic<bool> stop{false};
  int ticks = 0;
  int others = 0;
  ASSERT_TRUE(executor.add_task("control", 100.0, [&](const TickInfo&) noexcept { stop = ++ticks == 5; }));
  ASSERT_TRUE(executor.add_task("other", 100.0, [&](const TickInfo&) noexcept { ++others; }));
  executor.run(1000s, stop);
  EXPECT_EQ(ticks, 5);
  EXPECT_EQ(others, 4);
  EXPECT_EQ(clock.now(), 40ms);
  executor.run(1000s, stop);  // still stopped
  EXPECT_EQ(ticks, 5);
}

TEST(Executor, ASecondRunCountsItsReleasesAnew) {
  VirtualClock clock;
  Executor executor(clock);
  std::vector<std::uint64_t> releases;
  ASSERT_TRUE(executor.add_task("control", 100.0,
                                [&](const TickInfo& tick) noexcept { releases.push_back(tick.release); }));
  executor.run(20ms, kNeverStop);
  executor.run(15ms, kNeverStop);
  EXPECT_EQ(releases, (std::vector<std::uint64_t>{0, 1, 0, 1}));
  EXPECT_EQ(clock.now(), 35ms);
  EXPECT_EQ(executor.stats()[0].ticks, 4U);
}

TEST(Executor, ATaskIsAnArmedTickAndNothingElseIs) {
  VirtualClock clock;
  Executor executor(clock);
  int inside = 0;
  bool planner_inside = false;
  const auto look = [&](const TickInfo&) noexcept { inside += ArmedTick::is_now() ? 1 : 0; };
  ASSERT_TRUE(executor.add_task("control", 100.0, look, look));
  ASSERT_TRUE(executor.add_planner(
      "planner", 100.0, 0ns,
      [&](const TickInfo&) noexcept { planner_inside = planner_inside || ArmedTick::is_now(); },
      [&](const TickInfo&) noexcept { planner_inside = planner_inside || ArmedTick::is_now(); }));
  EXPECT_TRUE(executor.run(50ms, kNeverStop));
  EXPECT_EQ(inside, 10);
  EXPECT_FALSE(planner_inside);
  EXPECT_FALSE(ArmedTick::is_now());
}

TEST(Executor, AllocatesNothingWhileItRuns) {
  for (const bool virtual_time : {true, false}) {
    VirtualClock fast;
    RealtimeClock real;
    Clock& clock = virtual_time ? static_cast<Clock&>(fast) : real;
    Executor executor(clock);
    ASSERT_TRUE(executor.add_task("control", 1000.0, [](const TickInfo&) noexcept {}));
    ASSERT_TRUE(executor.add_task("record", 70.0, [](const TickInfo&) noexcept {}));
    const std::uint64_t before = allocation_count();
    executor.run(virtual_time ? Time(20s) : Time(20ms), kNeverStop);
    EXPECT_EQ(allocation_count(), before);
  }
}

// No promise about punctuality: only that releases are never early, never twice, and all accounted for.
TEST(Executor, RealTimeReleasesAreNeverEarlyAndAllAccountedFor) {
  RealtimeClock clock;
  Executor executor(clock);
  std::int64_t last = -1;
  bool early = false;
  bool repeated = false;
  ASSERT_TRUE(executor.add_task("control", 1000.0, [&](const TickInfo& tick) noexcept {
    early = early || tick.started < tick.scheduled || clock.now() < tick.scheduled;
    repeated = repeated || static_cast<std::int64_t>(tick.release) <= last;
    last = static_cast<std::int64_t>(tick.release);
  }));
  executor.run(50ms, kNeverStop);
  EXPECT_FALSE(early);
  EXPECT_FALSE(repeated);
  const TaskStats stats = executor.stats()[0];
  EXPECT_EQ(stats.ticks + stats.skipped, 50U);
  EXPECT_EQ(stats.jitter.has_value(), stats.ticks > 0);
}

}  // namespace
}  // namespace mayfly
