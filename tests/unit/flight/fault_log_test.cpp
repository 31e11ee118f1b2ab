#include "controller/flight/fault_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace mayfly {
namespace {

using namespace std::chrono_literals;

constexpr HalResult kFine{};
constexpr HalResult kSilent{HalFault::kRobotSilent, 1, "can0", "no answer"};
constexpr HalResult kDown{HalFault::kLinkDown, kEveryRobot, "can0", "bus off"};

const std::vector<RobotInfo> kRobots{{"anna", "can0"}, {"bert", "can0"}};

TEST(FaultLog, HoldsNothingWhereNothingHappened) {
  FaultLog log;
  FaultLog::Source source;
  log.note(source, 0s, kFine);
  EXPECT_EQ(log.count(), 0U);
  EXPECT_TRUE(log.told(kRobots).empty());
}

TEST(FaultLog, TellsWhenWhoWhereAndWhy) {
  FaultLog log;
  FaultLog::Source source;
  log.note(source, 1500ms, kSilent);
  const auto told = log.told(kRobots);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].time_s, 1.5);
  EXPECT_EQ(told[0].robot, "bert");
  EXPECT_EQ(told[0].link, "can0");
  EXPECT_EQ(told[0].cause, "no answer");
}

TEST(FaultLog, NamesNoRobotWhereAllOfALinkAreMeant) {
  FaultLog log;
  FaultLog::Source source;
  log.note(source, 0s, kDown);
  EXPECT_EQ(log.told(kRobots).at(0).robot, "");
}

// A heartbeat that is missing, then a process that is gone: the second says what became of it.
TEST(FaultLog, AnotherCauseIsAnotherFault) {
  FaultLog log;
  FaultLog::Source source;
  log.note(source, 0s, kDown);
  log.note(source, 1s, {HalFault::kLinkDown, kEveryRobot, "can0", "interface removed"});
  EXPECT_EQ(log.count(), 2U);
  EXPECT_EQ(log.told(kRobots).at(1).cause, "interface removed");
}

TEST(FaultLog, TakesAFaultThatGoesOnForOne) {
  FaultLog log;
  FaultLog::Source source;
  for (int tick = 0; tick < 100; ++tick) {
    log.note(source, tick * 10ms, kSilent);
  }
  EXPECT_EQ(log.count(), 1U);
  EXPECT_EQ(log.told(kRobots).at(0).time_s, 0.0);
}

TEST(FaultLog, TakesAFaultThatComesBackForAnother) {
  FaultLog log;
  FaultLog::Source source;
  log.note(source, 0s, kSilent);
  log.note(source, 1s, kFine);
  log.note(source, 2s, kSilent);
  EXPECT_EQ(log.count(), 2U);
  EXPECT_EQ(log.told(kRobots).at(1).time_s, 2.0);
}

TEST(FaultLog, TakesAnotherKindOrAnotherRobotForAnotherFault) {
  FaultLog log;
  FaultLog::Source source;
  HalResult other = kSilent;
  other.robot = 0;
  log.note(source, 0s, kSilent);
  log.note(source, 1s, kDown);
  log.note(source, 2s, kSilent);
  log.note(source, 3s, other);
  EXPECT_EQ(log.count(), 4U);
}

TEST(FaultLog, KeepsSourcesApart) {
  FaultLog log;
  FaultLog::Source reads;
  FaultLog::Source writes;
  for (int tick = 0; tick < 10; ++tick) {
    log.note(reads, tick * 1s, kDown);
    log.note(writes, tick * 1s, kFine);
  }
  EXPECT_EQ(log.count(), 1U);
}

TEST(FaultLog, KeepsAThousandAndSaysHowManyMoreThereWere) {
  FaultLog log;
  FaultLog::Source source;
  for (int fault = 0; fault < 1000; ++fault) {
    log.note(source, 0s, kSilent);
    log.note(source, 0s, kFine);
  }
  EXPECT_EQ(log.told(kRobots).size(), 1000U);
  for (int fault = 0; fault < 7; ++fault) {
    log.note(source, 0s, kSilent);
    log.note(source, 0s, kFine);
  }
  EXPECT_EQ(log.count(), 1007U);
  const auto told = log.told(kRobots);
  ASSERT_EQ(told.size(), 1001U);
  EXPECT_EQ(told[999].cause, "no answer");
  EXPECT_EQ(told[1000].cause, "7 more faults were not kept");
}

}  // namespace
}  // namespace mayfly
