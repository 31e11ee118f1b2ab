// How reactions of several symptoms, robots and links come together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/reference/allocation_count.hpp"
#include "tests/unit/safety/drill.hpp"

namespace mayfly::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Reactions, NothingIsWrongWithTheHealthy) {
  Drill drill;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(drill.tick(Symptoms{}), Severity::kNone);
    ASSERT_THAT(drill.reactions.begun(), IsEmpty());
  }
  EXPECT_EQ(drill.reactions.worst(), Severity::kNone);
}

TEST(Reactions, MayBeOfNobody) {
  Drill drill(std::vector<Reactions::Robot>{});
  drill.reactions.tick(kTick, {}, only(Symptom::kEmergencyStop));
  EXPECT_EQ(drill.reactions.worst(), Severity::kCut);
  EXPECT_EQ(drill.reactions.everybodys(), Severity::kCut);
  EXPECT_THAT(drill.reactions.severities(), IsEmpty());
}

TEST(Reactions, TheWorstWins) {
  Drill drill;
  Symptoms both = only(Symptom::kTrackingError);
  both.add(Symptom::kPoseJump);
  EXPECT_EQ(drill.tick(both, only(Symptom::kTickLate)), Severity::kHold);
  EXPECT_EQ(drill.tick(both, only(Symptom::kEmergencyStop)), Severity::kCut);
  EXPECT_THAT(drill.reactions.severities(), Each(Severity::kCut));
}

// All pairs of symptoms of one robot and of everybody: never milder than either alone.
TEST(Reactions, OfTwoSymptomsAtOnceIsTheWorseOne) {
  for (std::size_t a = 0; a < kSymptoms; ++a) {
    for (std::size_t b = 0; b < kSymptoms; ++b) {
      Drill one, other, both;
      for (int i = 0; i < 300; ++i) {
        const Severity first = one.tick(only(static_cast<Symptom>(a)));
        const Severity second = other.tick({}, only(static_cast<Symptom>(b)));
        const Severity together = both.tick(only(static_cast<Symptom>(a)), only(static_cast<Symptom>(b)));
        ASSERT_EQ(together, std::max(first, second)) << a << " and " << b << " after " << i;
      }
    }
  }
}

// Whatever comes: from kHoldAll up nothing falls without an acknowledge.
TEST(Reactions, NeverFallsFromHoldAllWithoutAnAcknowledge) {
  std::mt19937 random(1);
  Drill drill;
  std::vector<Severity> last(3, Severity::kNone);
  for (int i = 0; i < 200'000; ++i) {
    for (Symptoms& symptoms : drill.robots) {
      symptoms = random() % 8 == 0 ? only(static_cast<Symptom>(random() % kSymptoms)) : Symptoms{};
    }
    const bool acknowledges = random() % 64 == 0;
    if (acknowledges) {
      drill.reactions.acknowledge();
    }
    const Symptoms everybody =
        random() % 512 == 0 ? only(static_cast<Symptom>(random() % kSymptoms)) : Symptoms{};
    drill.now += kTick;
    drill.reactions.tick(drill.now, drill.robots, everybody);
    for (std::size_t robot = 0; robot < 3; ++robot) {
      const Severity now = drill.reactions.severities()[robot];
      ASSERT_TRUE(acknowledges || last[robot] < Severity::kHoldAll || now >= last[robot]) << i;
      last[robot] = now;
    }
  }
}

TEST(Reactions, AfterAnAcknowledgeDelaysBeginAnew) {
  Drill drill;
  while (drill.tick(only(Symptom::kStalePose)) < Severity::kLand) {
  }
  drill.tick(Symptoms{});
  EXPECT_EQ(drill.reactions.acknowledge(), Severity::kNone);
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose)), Severity::kHold) << "not landing at once";
}

TEST(Reactions, AnAcknowledgeOfOneLeavesTheOther) {
  Drill drill;
  drill.robots[2] = only(Symptom::kBatteryCritical);
  while (drill.tick(only(Symptom::kBatteryCritical)) < Severity::kLand) {
  }
  for (int i = 0; i < 600; ++i) {
    drill.tick(Symptoms{});  // the first is well again, the third is not
  }
  EXPECT_EQ(drill.reactions.acknowledge(), Severity::kLand);
  EXPECT_THAT(drill.reactions.severities(), ElementsAre(Severity::kNone, Severity::kNone, Severity::kLand));
}

TEST(Reactions, OneThatIsNotWatchedAnswersOnlyForEverybody) {
  Drill drill(std::vector<Reactions::Robot>{{0, false}, {0, true}, {0, true}});
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(drill.tick(only(Symptom::kStalePose)), Severity::kNone);
  }
  EXPECT_EQ(drill.tick({}, only(Symptom::kOperatorHold)), Severity::kHoldAll);
}

TEST(Reactions, TimeIsTheClocksNotTheTicks) {
  Drill drill;
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose)), Severity::kHold);
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose), {}, std::chrono::milliseconds(499)), Severity::kHold);
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose), {}, std::chrono::milliseconds(1)), Severity::kLand);
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose), {}, std::chrono::hours(1)), Severity::kCut);
}

TEST(Reactions, AClockThatGoesBackAccruesNothing) {
  Drill drill;
  drill.tick(only(Symptom::kStalePose), {}, std::chrono::hours(1));
  EXPECT_EQ(drill.tick(only(Symptom::kStalePose), {}, -std::chrono::hours(1)), Severity::kHold);
}

TEST(Reactions, CountsWhatShowedAndWhatBegan) {
  Drill drill;
  for (int i = 0; i < 60; ++i) {
    drill.tick(only(Symptom::kStalePose));
  }
  const ReactionCounters& counted = drill.reactions.counters();
  EXPECT_EQ(counted.by_symptom[static_cast<std::size_t>(Symptom::kStalePose)], 60U);
  EXPECT_EQ(counted.begun[static_cast<std::size_t>(Severity::kHold)], 1U);
  EXPECT_EQ(counted.begun[static_cast<std::size_t>(Severity::kLand)], 1U);
  EXPECT_EQ(counted.begun[static_cast<std::size_t>(Severity::kCut)], 0U);
}

TEST(Reactions, WhatBeginsBeyondTheListIsCounted) {
  Drill drill(std::vector<Reactions::Robot>(3000));
  std::fill(drill.robots.begin(), drill.robots.end(), only(Symptom::kStalePose));
  drill.tick(only(Symptom::kStalePose));
  EXPECT_EQ(drill.reactions.begun().size() + drill.reactions.counters().unlisted, 3000U);
  EXPECT_GT(drill.reactions.counters().unlisted, 0U);
}

TEST(Reactions, ATickAllocatesNothing) {
  Drill drill(std::vector<Reactions::Robot>(2000));
  std::fill(drill.robots.begin(), drill.robots.end(), only(Symptom::kFrozenPose));
  const std::uint64_t before = allocation_count();
  for (int i = 0; i < 300; ++i) {
    drill.tick(only(Symptom::kLinkLost), only(Symptom::kTickLate));
  }
  drill.reactions.acknowledge();
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace mayfly::test
