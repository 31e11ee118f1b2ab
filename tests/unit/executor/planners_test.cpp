// Tasks beside control: their order on a virtual clock, their latency, and their threads.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "controller/clock/realtime_clock.hpp"
#include "controller/clock/virtual_clock.hpp"
#include "controller/executor/executor.hpp"
#include "tests/unit/executor/scripted_clock.hpp"

namespace mayfly {
namespace {

using namespace std::chrono_literals;

const std::atomic<bool> kNeverStop{false};

// What happened, with the time in ms: "s0 w0 a0 p20".
class Log {
 public:
  explicit Log(const Clock& clock) : clock_(clock) {}
  auto note(std::string what) {
    return [this, what = std::move(what)](const TickInfo&) noexcept {
      text_ += what + std::to_string(clock_.now() / 1ms) + ' ';
    };
  }
  const std::string& text() const { return text_; }

 private:
  const Clock& clock_;
  std::string text_;
};

TEST(Planners, AResultIsThereAfterItsLatencyAndBeforeControlOfThatMoment) {
  VirtualClock clock;
  Executor executor(clock);
  Log log(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, log.note("s"), log.note("a")));
  ASSERT_TRUE(executor.add_planner("planner", 50.0, 20ms, log.note("w"), log.note("p")));
  ASSERT_TRUE(executor.run(45ms, kNeverStop));
  EXPECT_EQ(log.text(), "s0 w0 a0 s10 a10 p20 s20 w20 a20 s30 a30 p40 s40 w40 a40 ");
}

TEST(Planners, WithoutLatencyTheResultIsThereBetweenTheHalvesOfTheTick) {
  VirtualClock clock;
  Executor executor(clock);
  Log log(clock);
  ASSERT_TRUE(executor.add_task("control", 100.0, log.note("s"), log.note("a")));
  ASSERT_TRUE(executor.add_planner("planner", 100.0, 0ms, log.note("w"), log.note("p")));
  ASSERT_TRUE(executor.run(15ms, kNeverStop));
  EXPECT_EQ(log.text(), "s0 w0 p0 a0 s10 w10 p10 a10 ");
}

TEST(Planners, WorkAtTimesOfTheirOwnBesideATaskOfOnePiece) {
  VirtualClock clock;
  Executor executor(clock);
  Log log(clock);
  ASSERT_TRUE(executor.add_task("control", 50.0, log.note("c")));
  ASSERT_TRUE(executor.add_planner("slow", 40.0, 5ms, log.note("w"), log.note("p")));
  ASSERT_TRUE(executor.run(50ms, kNeverStop));
  EXPECT_EQ(log.text(), "c0 w0 p5 c20 w25 p30 c40 ");
}

TEST(Planners, TwoAtOneMomentKeepTheOrderOfAdding) {
  VirtualClock clock;
  Executor executor(clock);
  Log log(clock);
  ASSERT_TRUE(executor.add_planner("b", 10.0, 100ms, log.note("b"), log.note("B")));
  ASSERT_TRUE(executor.add_planner("a", 20.0, 50ms, log.note("a"), log.note("A")));
  ASSERT_TRUE(executor.run(101ms, kNeverStop));
  EXPECT_EQ(log.text(), "b0 a0 A50 a50 B100 A100 b100 a100 ");
}

TEST(Planners, ALatencyLongerThanThePeriodIsRefusedAndSoAreOldNames) {
  VirtualClock clock;
  Executor executor(clock);
  const auto nothing = [](const TickInfo&) noexcept {};
  EXPECT_TRUE(executor.add_planner("p", 100.0, 10ms, nothing, nothing));
  EXPECT_FALSE(executor.add_planner("q", 100.0, 10ms + 1ns, nothing, nothing));
  EXPECT_FALSE(executor.add_planner("q", 100.0, -1ns, nothing, nothing));
  EXPECT_FALSE(executor.add_planner("q", 0.0, 0ns, nothing, nothing));
  EXPECT_FALSE(executor.add_planner("p", 100.0, 0ns, nothing, nothing));
  EXPECT_FALSE(executor.add_task("p", 100.0, nothing));
  EXPECT_TRUE(executor.add_task("q", 100.0, nothing));
  const auto stats = executor.stats();
  ASSERT_EQ(stats.size(), 2U);
  EXPECT_EQ(stats[0].name, "q");  // the control thread's first
  EXPECT_FALSE(stats[0].own_thread);
  EXPECT_TRUE(stats[1].own_thread);
}

TEST(Planners, AResultOfTheRunBeforeIsNotHandedOverInTheNext) {
  VirtualClock clock;
  Executor executor(clock);
  Log log(clock);
  ASSERT_TRUE(executor.add_planner("p", 10.0, 100ms, log.note("w"), log.note("p")));
  ASSERT_TRUE(executor.run(60ms, kNeverStop));
  ASSERT_TRUE(executor.run(60ms, kNeverStop));
  EXPECT_EQ(log.text(), "w0 w60 ");
}

TEST(PlannerThread, SkipsWhatItIsTooLateForAndNeverBursts) {
  ScriptedClock clock;
  std::vector<std::uint64_t> releases;
  int published = 0;
  PlannerTask planner{*Releases::make("p", 100.0), 0ns,
                      [&](const TickInfo& info) noexcept {
                        releases.push_back(info.release);
                        clock.work(info.release == 2 ? 35ms : 1ms);
                      },
                      [&](const TickInfo&) noexcept { ++published; }};
  const std::atomic<bool> ending{false};
  serve_planner(planner, clock, clock.now(), 100ms, ending);
  EXPECT_EQ(releases, (std::vector<std::uint64_t>{0, 1, 2, 5, 6, 7, 8, 9}));
  EXPECT_EQ(published, 8);
  const TaskStats stats = planner.releases.stats();
  EXPECT_EQ(stats.missed, 3U);
  EXPECT_EQ(stats.skipped, 2U);
  EXPECT_EQ(stats.missed_by_machine, 0U);
}

// Its sleep is cut into naps; a release in a later nap is overslept all the same.
TEST(PlannerThread, ALateWakeUpIsTheMachines) {
  ScriptedClock clock;
  PlannerTask planner{*Releases::make("p", 5.0), 0ns,
                      [&](const TickInfo& info) noexcept {
                        clock.work(1ms);
                        clock.oversleep = info.release == 0 ? 450ms : 0ms;
                      },
                      [](const TickInfo&) noexcept {}};
  const std::atomic<bool> ending{false};
  serve_planner(planner, clock, clock.now(), 1s, ending);
  const TaskStats stats = planner.releases.stats();
  EXPECT_EQ(stats.skipped, 1U);  // release 1, from 200 to 400 ms
  EXPECT_EQ(stats.missed_by_machine, 1U);
}

// On the real clock as on the virtual one: nothing flies differently because a machine is fast.
TEST(PlannerThread, PublishesWhenTheLatencyHasPassedOrLaterIfItWorkedLonger) {
  ScriptedClock clock;
  const Time start = clock.now();
  std::vector<Time> published;
  PlannerTask planner{*Releases::make("p", 10.0), 60ms,
                      [&](const TickInfo& info) noexcept { clock.work(info.release == 1 ? 70ms : 1ms); },
                      [&](const TickInfo&) noexcept { published.push_back(clock.now() - start); }};
  const std::atomic<bool> ending{false};
  serve_planner(planner, clock, start, 300ms, ending);
  EXPECT_EQ(published, (std::vector<Time>{60ms, 170ms, 260ms}));
  EXPECT_EQ(planner.releases.stats().missed, 0U);
}

TEST(PlannerThread, EndsBetweenTwoReleasesHoweverRareTheyAre) {
  ScriptedClock clock;
  std::atomic<bool> ending{false};
  PlannerTask planner{*Releases::make("p", 0.01), 0ns, [&](const TickInfo&) noexcept { ending = true; },
                      [](const TickInfo&) noexcept {}};
  const Time start = clock.now();
  serve_planner(planner, clock, start, 1h, ending);
  EXPECT_EQ(clock.now(), start);
}

// A planner that takes as long as it likes does not keep control from any release; no promise how punctual.
TEST(PlannerThread, ControlGoesOnWhileAPlannerWorks) {
  RealtimeClock clock;
  Executor executor(clock);
  executor.set_realtime({.witness = true});
  std::atomic<int> ticks{0};
  std::atomic<bool> waited{false};
  ASSERT_TRUE(executor.add_task("control", 500.0, [&](const TickInfo&) noexcept { ++ticks; }));
  ASSERT_TRUE(executor.add_planner(
      "planner", 500.0, 0ns,
      [&](const TickInfo&) noexcept {
        while (ticks < 5) {  // would never end, if control waited for it
          std::this_thread::yield();
        }
        waited = true;
      },
      [](const TickInfo&) noexcept {}));
  std::atomic<bool> stop{false};
  ASSERT_TRUE(executor.add_task("end", 500.0, [&](const TickInfo&) noexcept { stop = waited.load(); }));
  ASSERT_TRUE(executor.run(100s, stop));
  EXPECT_GE(ticks, 5);
  EXPECT_GE(executor.stats()[2].ticks, 1U);
}

}  // namespace
}  // namespace mayfly
