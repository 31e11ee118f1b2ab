#include "controller/link/segment.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/unit/link/link_pair.hpp"

namespace mayfly::link::test {
namespace {

using ::testing::HasSubstr;

Segment make(std::size_t robots) {
  auto segment = Segment::create(roster_of(some_robots(robots)), Time(123));
  EXPECT_TRUE(segment);
  return std::move(*segment);
}

std::string refusal(int descriptor, const Roster& roster) {
  const auto attached = Segment::attach(descriptor, roster);
  return attached ? "" : to_string(attached.error());
}

int copy_of(const Segment& segment) {
  return ::fcntl(segment.descriptor(), F_DUPFD_CLOEXEC, 0);
}

TEST(Segment, BothSidesSeeTheSameMemory) {
  const Segment one = make(5);
  const Segment other = same_segment(one, 5);
  EXPECT_EQ(other.robots(), 5U);
  EXPECT_EQ(other.epoch(), Time(123));
  one.header().guard_beat = 77;
  EXPECT_EQ(other.header().guard_beat.load(), 77U);
}

TEST(Segment, NobodyCanResizeIt) {
  const Segment segment = make(5);
  EXPECT_NE(::ftruncate(segment.descriptor(), 0), 0);
  EXPECT_NE(::ftruncate(segment.descriptor(), 1 << 24), 0);
}

TEST(Segment, NoRobotsIsASegmentToo) {
  const Segment one = make(0);
  EXPECT_EQ(same_segment(one, 0).robots(), 0U);
}

TEST(Segment, AnotherVersionIsRefused) {
  const Segment segment = make(5);
  segment.header().version = kVersion + 1;
  EXPECT_THAT(refusal(copy_of(segment), roster_of(some_robots(5))),
              AllOf(HasSubstr("the version"), HasSubstr("found 3; wanted 2")));
}

TEST(Segment, AnotherNumberOfRobotsIsRefused) {
  EXPECT_THAT(refusal(copy_of(make(5)), roster_of(some_robots(6))),
              AllOf(HasSubstr("the number of robots"), HasSubstr("found 5; wanted 6")));
}

TEST(Segment, OtherRobotsAreRefused) {
  std::vector<RobotInfo> others = some_robots(5);
  std::swap(others[1], others[2]);
  EXPECT_THAT(refusal(copy_of(make(5)), roster_of(others)), HasSubstr("the names of the robots"));
}

TEST(Segment, AnotherLayoutIsRefused) {
  const Segment segment = make(5);
  segment.header().layout.fetch_add(1);
  EXPECT_THAT(refusal(copy_of(segment), roster_of(some_robots(5))), HasSubstr("the layout"));
}

TEST(Segment, WhatIsNotASegmentIsRefused) {
  const Roster roster = roster_of(some_robots(5));
  EXPECT_THAT(refusal(-1, roster), HasSubstr("no segment"));
  EXPECT_THAT(refusal(::open("/dev/null", O_RDWR | O_CLOEXEC), roster), HasSubstr("no segment"));
  const Segment segment = make(5);
  segment.header().magic = 1;
  EXPECT_THAT(refusal(copy_of(segment), roster), HasSubstr("no segment"));
}

TEST(Segment, WhatCanBeShrunkUnderUsIsRefused) {
  const int file = ::memfd_create("not sealed", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  ASSERT_EQ(::ftruncate(file, 1 << 20), 0);
  EXPECT_THAT(refusal(file, roster_of(some_robots(5))), HasSubstr("can be shrunk"));
}

TEST(Segment, WhatIsShorterThanItSaysIsRefused) {
  const int file = ::memfd_create("short", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  ASSERT_EQ(::ftruncate(file, sizeof(Header)), 0);
  const Segment whole = make(5);
  ASSERT_EQ(::pwrite(file, &whole.header(), sizeof(Header), 0), static_cast<ssize_t>(sizeof(Header)));
  ASSERT_EQ(::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL), 0);
  EXPECT_THAT(refusal(file, roster_of(some_robots(5))), HasSubstr("the size"));
}

TEST(Lease, OnePlannerAndOneGuard) {
  const auto planner = PlannerEnd::make(make(3));
  ASSERT_TRUE(planner);
  const auto second = PlannerEnd::make(same_segment(planner->segment(), 3));
  ASSERT_FALSE(second);
  EXPECT_THAT(to_string(second.error()),
              AllOf(HasSubstr("already a planner"), HasSubstr("process " + std::to_string(::getpid()))));
  ASSERT_TRUE(GuardEnd::make(same_segment(planner->segment(), 3), Pair::kMostAge));
  const auto guard = GuardEnd::make(same_segment(planner->segment(), 3), Pair::kMostAge);
  ASSERT_FALSE(guard);
  EXPECT_THAT(to_string(guard.error()), HasSubstr("already a guard"));
}

TEST(Lease, AGuardWithoutAPlannerIsRefused) {
  const auto guard = GuardEnd::make(make(3), Pair::kMostAge);
  ASSERT_FALSE(guard);
  EXPECT_THAT(to_string(guard.error()), HasSubstr("no planner"));
}

}  // namespace
}  // namespace mayfly::link::test
