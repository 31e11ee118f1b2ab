// The planner stands still for a while and goes on: SIGSTOP, a debugger, a machine that sleeps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/sim/guard_process/two_processes.hpp"

namespace mayfly::test {
namespace {

constexpr double kPeriod = 5e-3;  // s

TEST(Pause, RobotsStopMeanwhileAndNothingIsMadeUpForAfterwards) {
  TwoProcesses flight({"--duration", "2"});
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(60));
  flight.send_planner(SIGSTOP);
  const Time stopped = monotonic_now();
  // A hundred of the guard's ticks.
  const link::Word until = flight.header().guard_beat.load() + 100;
  while (flight.header().guard_beat.load() < until) {
    std::this_thread::yield();
  }
  const auto stop = flight.wait_for_stop(stopped);
  ASSERT_TRUE(stop);
  const double pause = to_seconds(monotonic_now() - stopped);
  flight.send_planner(SIGCONT);
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 0) << ended.error;

  EXPECT_FALSE(flight.guard_report()["planner_died"].get<bool>());
  EXPECT_LE(to_seconds(stop->still - stopped), 50e-3 + to_seconds(stop->late));
  // Every release of the planner's is a tick or is missed: those of the pause were not flown in a burst.
  const nlohmann::json control = flight.summary()["control"];
  EXPECT_GE(control["missed"].get<double>() * kPeriod, pause - 2 * kPeriod);
  EXPECT_LE(control["ticks"].get<double>() * kPeriod, 2.0 - pause + 2 * kPeriod);
}

}  // namespace
}  // namespace mayfly::test
