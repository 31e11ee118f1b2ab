// How flights in two processes end: well, by a signal, and without their guard.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>

#include "controller/link/process_watch.hpp"
#include "tests/sim/guard_process/two_processes.hpp"

namespace mayfly::test {
namespace {

using ::testing::HasSubstr;

TEST(End, AFlightThatIsOverBringsItsRobotsToRest) {
  TwoProcesses flight({"--duration", "0.5"});
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 0) << ended.error;
  EXPECT_EQ(ended.error, "");
  const nlohmann::json report = flight.guard_report();
  EXPECT_FALSE(report["planner_died"].get<bool>());
  EXPECT_EQ(report["refused"], 0);
  EXPECT_GT(report["wishes"], 0);
  EXPECT_EQ(flight.summary()["hal"], "guard");
}

TEST(End, InterruptedTogetherTheGuardOutlivesThePlanner) {
  TwoProcesses flight;
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(40));
  flight.send_guard(SIGINT);
  flight.send_planner(SIGINT);
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 128 + SIGINT) << ended.error;
  EXPECT_THAT(ended.out, HasSubstr("stopped by the user"));
  ASSERT_FALSE(flight.guard_report().is_discarded());
  EXPECT_FALSE(flight.guard_report()["planner_died"].get<bool>());
}

TEST(End, InterruptedTwiceTheGuardStopsAllAtOnceAndStillEndsWell) {
  TwoProcesses flight;
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(40));
  for (const int signal : {SIGINT, SIGINT}) {
    flight.send_guard(signal);
    flight.send_planner(signal);
  }
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 128 + SIGINT) << ended.error;
  ASSERT_FALSE(flight.guard_report().is_discarded());
}

// A driver that hangs, or a file that is slow, cannot keep it from its robots.
TEST(Guard, HasNoOpenClDriverAndNoFileOpenInFlight) {
  TwoProcesses flight({"--duration", "0.5"});
  ASSERT_TRUE(flight.fly());
  const std::filesystem::path self = "/proc/" + std::to_string(flight.guard());
  EXPECT_THAT(text_of(self / "maps"), ::testing::Not(HasSubstr("pocl")));
  for (const auto& entry : std::filesystem::directory_iterator(self / "fd")) {
    const std::string open = std::filesystem::read_symlink(entry.path()).string();
    EXPECT_THAT(open, ::testing::MatchesRegex("(pipe:|socket:|anon_inode:|/memfd:|/dev/).*"));
  }
  EXPECT_EQ(flight.wait().exit_code, 0);
}

TEST(End, AGuardWithoutAPlannerLandsItsRobotsAndEnds) {
  TwoProcesses flight;
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(40));
  flight.send_planner(SIGKILL);
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 128 + SIGKILL);
  EXPECT_THAT(ended.error, HasSubstr("the planner has ended without a word"));
  const nlohmann::json report = flight.guard_report();
  ASSERT_FALSE(report.is_discarded());
  EXPECT_TRUE(report["planner_died"].get<bool>());
  EXPECT_GE(report["stops"].size(), 1U);
}

// What kills a planner at once does not kill a guard: nor does the terminal's end.
TEST(End, TheGuardOutlivesThreeInterruptsAndAClosedTerminal) {
  TwoProcesses flight;
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(40));
  for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGINT, SIGINT}) {
    flight.send_guard(signal);
  }
  flight.send_planner(SIGKILL);
  EXPECT_EQ(flight.wait().exit_code, 128 + SIGKILL);
  ASSERT_FALSE(flight.guard_report().is_discarded());
  EXPECT_TRUE(flight.guard_report()["planner_died"].get<bool>());
}

TEST(End, APlannerWhoseGuardIsKilledSaysSoAndEnds) {
  TwoProcesses flight;
  ASSERT_TRUE(flight.fly() && flight.wait_for_beats(40));
  const auto guard = link::ProcessWatch::of(flight.guard());
  ASSERT_TRUE(guard);
  flight.send_guard(SIGKILL);
  ASSERT_TRUE(guard->has_ended(std::chrono::seconds(60)));
  const Outcome ended = flight.wait();
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.error, HasSubstr("the guard was killed by signal 9"));
  EXPECT_THAT(ended.out, ::testing::Not(HasSubstr("stopped by the user")));
  // In ticks, not in time: it ends in the one after that in which it has seen it. Ticks that a busy machine
  // did not serve are in the planner's own account.
  const nlohmann::json summary = flight.summary();
  double seen = -1.0;
  for (const auto& fault : summary["faults"]) {
    const bool is_it =
        fault["cause"].get<std::string>().find("left to their own watchdogs") != std::string::npos;
    seen = is_it ? fault["time_s"].get<double>() : seen;
  }
  ASSERT_GE(seen, 0.0) << summary["faults"].dump();
  const double period = 1.0 / 200.0;
  const double served = summary["control"]["missed"].get<double>() + 3.0;
  EXPECT_LE(summary["simulated_s"].get<double>() - seen, served * period);
}

}  // namespace
}  // namespace mayfly::test
