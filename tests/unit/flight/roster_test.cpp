// Who is there, and what a flight does with those who are not.
#include "controller/flight/roster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/flight/sortie.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::SizeIs;

std::vector<int> there_at(Roster& roster, double time_s) {
  roster.set_time(time_s);
  return {roster.present().begin(), roster.present().end()};
}

TEST(Roster, WithoutAKeyEverybodyIsAlwaysThere) {
  const Scenario scenario = hall(3);
  Roster roster(scenario);
  roster.set_time(17.0);
  EXPECT_FALSE(roster.changes());
  EXPECT_TRUE(roster.present().empty());
  EXPECT_TRUE(roster.is_there(2));
}

TEST(Roster, AgentsJoinOneAfterTheOtherUntilAllAreThere) {
  Scenario scenario = hall(4);
  scenario.swarms[0].join = JoinSpec{1, 2.0F};
  Roster roster(scenario);
  EXPECT_THAT(there_at(roster, 0.0), ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(there_at(roster, 0.49), ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(there_at(roster, 0.5), ElementsAre(1, 1, 0, 0));
  EXPECT_THAT(there_at(roster, 1.5), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(there_at(roster, 1e6), ElementsAre(1, 1, 1, 1));
}

TEST(Roster, TheyLeaveFromTheFrontAndNoMoreThanSaid) {
  Scenario scenario = hall(4);
  scenario.swarms[0].leave = LeaveSpec{1.0F, 1.0F, 2};
  Roster roster(scenario);
  EXPECT_THAT(there_at(roster, 0.99), ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(there_at(roster, 1.0), ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(there_at(roster, 2.0), ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(there_at(roster, 99.0), ElementsAre(0, 0, 1, 1));
}

TEST(Roster, WhoWouldLeaveBeforeJoiningIsNeverThere) {
  Scenario scenario = hall(2);
  scenario.swarms[0].join = JoinSpec{0, 0.1F};
  scenario.swarms[0].leave = LeaveSpec{0.0F, 10.0F, 2};
  Roster roster(scenario);
  for (const double time_s : {0.0, 0.05, 5.0, 10.0, 20.0, 1000.0}) {
    EXPECT_THAT(there_at(roster, time_s), Each(0)) << time_s;
  }
}

TEST(Roster, EachSwarmHasItsOwn) {
  Scenario scenario = hall(2);
  scenario.swarms.push_back(scenario.swarms[0]);
  scenario.swarms[1].join = JoinSpec{0, 1.0F};
  Roster roster(scenario);
  EXPECT_THAT(there_at(roster, 0.0), ElementsAre(1, 1, 0, 0));
  EXPECT_THAT(there_at(roster, 1.0), ElementsAre(1, 1, 1, 0));
}

TEST(Roster, AllocatesNothingInFlight) {
  Scenario scenario = hall(1000);
  scenario.swarms[0].join = JoinSpec{1, 2.0F};
  Roster roster(scenario);
  const std::uint64_t before = allocation_count();
  roster.set_time(3.0);
  EXPECT_EQ(allocation_count(), before);
}

TEST(RosterInFlight, WhoIsNotThereHoldsAndIsInNobodysWay) {
  Scenario scenario = hall(3);
  scenario.swarms[0].join = JoinSpec{1, 10.0F};
  Sortie sortie(std::move(scenario));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary) << to_string(summary.error());
  ASSERT_THAT(sortie.hal.written, SizeIs(20));
  EXPECT_THAT(sortie.hal.written[0].kinds,
              ElementsAre(CommandKind::kVelocity, CommandKind::kHold, CommandKind::kHold));
  EXPECT_THAT(sortie.hal.written[9].kinds,
              ElementsAre(CommandKind::kVelocity, CommandKind::kHold, CommandKind::kHold));
  EXPECT_THAT(sortie.hal.written[10].kinds,
              ElementsAre(CommandKind::kVelocity, CommandKind::kVelocity, CommandKind::kHold));
  EXPECT_THAT(summary->faults, SizeIs(0));
}

TEST(RosterInFlight, ASwarmOfWhomNobodyHasJoinedHasNoSeparation) {
  Scenario scenario = hall(3);
  scenario.swarms[0].join = JoinSpec{0, 0.001F};
  Sortie sortie(std::move(scenario));
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_EQ(summary->min_separation_m, std::nullopt);
  EXPECT_EQ(summary->collisions, 0U);
}

// One missing robot never stops the others.
TEST(RosterInFlight, ARobotThatWasNeverSeenHoldsAndTheOthersArrive) {
  Scenario scenario = hall(4);
  scenario.duration = 20;
  scenario.swarms[0].model = Model::kOrca;
  scenario.swarms[0].avoidance.on = true;
  Sortie sortie(std::move(scenario));
  sortie.hal.silent = {2};
  const auto summary = sortie.fly();
  ASSERT_TRUE(summary) << to_string(summary.error());
  EXPECT_EQ(summary->reached_fraction, 0.75);
  for (const auto& tick : sortie.hal.written) {
    ASSERT_EQ(tick.kinds[2], CommandKind::kHold);
  }
}

}  // namespace
}  // namespace mayfly::test
