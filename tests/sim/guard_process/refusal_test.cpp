// Whom a guard does not fly for.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "controller/link/guard_end.hpp"
#include "controller/link/planner_end.hpp"
#include "controller/link/process_watch.hpp"
#include "tests/sim/guard_process/two_processes.hpp"

namespace mayfly::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<RobotInfo> flies(std::size_t count) {
  std::vector<RobotInfo> robots;
  for (std::size_t robot = 0; robot < count; ++robot) {
    robots.push_back({"flies_" + std::to_string(robot), "sim"});
  }
  return robots;
}

// A guard that is started by hand, with descriptors that it inherits.
class Refused : public ::testing::Test {
 protected:
  Outcome start(int segment) const {
    const int inherited = ::fcntl(segment, F_DUPFD, 0);
    const auto self = link::ProcessWatch::of(::getpid());
    const int planner = ::fcntl(self->descriptor(), F_DUPFD, 0);
    const Outcome outcome = run_program({"guard", write_restless_scenario(folder_), "--segment",
                                         std::to_string(inherited), "--planner", std::to_string(planner)});
    ::close(inherited);
    ::close(planner);
    return outcome;
  }

  TemporaryFolder folder_;
};

TEST_F(Refused, ASegmentOfAnotherVersion) {
  const auto segment = link::Segment::create(link::roster_of(flies(12)), Time(1));
  segment->header().version = link::kVersion + 1;
  const Outcome outcome = start(segment->descriptor());
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("the version"), HasSubstr("found 3; wanted 2")));
}

TEST_F(Refused, ASegmentForAnotherNumberOfRobots) {
  const auto segment = link::Segment::create(link::roster_of(flies(13)), Time(1));
  const Outcome outcome = start(segment->descriptor());
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("the number of robots"), HasSubstr("found 13; wanted 12")));
}

TEST_F(Refused, ASegmentWithoutAPlanner) {
  const auto segment = link::Segment::create(link::roster_of(flies(12)), Time(1));
  const Outcome outcome = start(segment->descriptor());
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("no planner"));
}

TEST_F(Refused, DescriptorsThatAreNone) {
  const Outcome outcome =
      run_program({"guard", write_restless_scenario(folder_), "--segment", "98", "--planner", "99"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("is not one of a process"));
}

TEST_F(Refused, ASecondGuardAndASecondPlannerOfAFlight) {
  TwoProcesses flight({"--duration", "5"});
  ASSERT_TRUE(flight.fly());
  const Outcome guard = start(flight.segment_descriptor());
  EXPECT_EQ(guard.exit_code, 3);
  EXPECT_THAT(guard.error, HasSubstr("already a guard"));
  const auto planner =
      link::PlannerEnd::make(*link::Segment::attach(flight.segment_descriptor(), link::roster_of(flies(12))));
  ASSERT_FALSE(planner);
  EXPECT_THAT(to_string(planner.error()),
              AllOf(HasSubstr("already a planner"), HasSubstr(std::to_string(flight.planner()))));
  flight.send_planner(SIGINT);
  EXPECT_EQ(flight.wait().exit_code, 128 + SIGINT);
}

TEST_F(Refused, AVirtualClock) {
  const Outcome outcome =
      run_program({"run", write_restless_scenario(folder_), "--guard", "process", "--fast"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("real time"));
}

}  // namespace
}  // namespace mayfly::test
