// Every row of the table, one by one: it fires, not one tick early, in the tick that it is due, and it ends
// or stays as the table says.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/unit/safety/drill.hpp"

namespace mayfly::test {
namespace {

struct Case {
  std::size_t index;
  ReactionRow row;
  // The severity that the row before it of the same symptom has, or none.
  Severity before = Severity::kNone;
  bool of_everybody() const {
    return row.scope == Scope::kEverybody &&
           (row.symptom >= Symptom::kIdSwap && row.symptom != Symptom::kLinkLost);
  }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const ReactionRow& row : reaction_table()) {
    Case one{all.size(), row};
    if (!all.empty() && all.back().row.symptom == row.symptom) {
      one.before = all.back().row.severity;
    }
    all.push_back(one);
  }
  return all;
}

class EachRow : public ::testing::TestWithParam<Case> {
 protected:
  Severity shown(bool shows = true) {
    return drill_.tick(shows, GetParam().row.symptom, GetParam().of_everybody());
  }
  // Ticks that show the symptom until the row is due, the one that makes it so included.
  std::int64_t ticks_until_due() const {
    const std::int64_t delay = (GetParam().row.after + kTick - Time(1)) / kTick + 1;
    return std::max<std::int64_t>(delay, GetParam().row.times);
  }
  void fire() {
    for (std::int64_t i = 0; i < ticks_until_due(); ++i) {
      shown();
    }
  }
  Severity severity() const { return drill_.reactions.severities()[0]; }
  bool is_latched() const { return GetParam().row.severity >= Severity::kHoldAll; }

  Drill drill_;
};

TEST_P(EachRow, FiresInTheTickThatMakesItDueAndInNoneBefore) {
  for (std::int64_t i = 1; i < ticks_until_due(); ++i) {
    ASSERT_LE(shown(), GetParam().before) << "after " << i << " ticks";
  }
  EXPECT_EQ(shown(), GetParam().row.severity);
  const auto begun = drill_.reactions.begun();
  const auto mine = std::find_if(begun.begin(), begun.end(), [](const Reaction& reaction) {
    return reaction.symptom == GetParam().row.symptom && reaction.severity == GetParam().row.severity;
  });
  ASSERT_NE(mine, begun.end());
  EXPECT_EQ(mine->robot, GetParam().of_everybody() ? kEveryRobot : 0U);
}

TEST_P(EachRow, BeginsOnce) {
  fire();
  shown();
  EXPECT_TRUE(
      std::none_of(drill_.reactions.begun().begin(), drill_.reactions.begun().end(),
                   [](const Reaction& reaction) { return reaction.severity == GetParam().row.severity; }));
}

TEST_P(EachRow, ReachesThoseInItsScope) {
  fire();
  const auto severities = drill_.reactions.severities();
  const Severity expected = GetParam().row.severity;
  const bool link = GetParam().row.scope != Scope::kRobot;
  const bool all = GetParam().row.scope == Scope::kEverybody;
  EXPECT_EQ(severities[1], link ? expected : Severity::kNone);
  EXPECT_EQ(severities[2], all ? expected : Severity::kNone);
  EXPECT_EQ(drill_.reactions.worst(), expected);
}

TEST_P(EachRow, EndsAfterItsTimeInHealthUnlessItIsLatched) {
  fire();
  const Time clears = std::max(info_of(GetParam().row.symptom).clears, Time(1));
  const std::int64_t ticks = (clears + kTick - Time(1)) / kTick;
  for (std::int64_t i = 1; i < ticks; ++i) {
    ASSERT_EQ(shown(false), GetParam().row.severity) << "after " << i << " healthy ticks";
  }
  shown(false);
  EXPECT_EQ(severity(), is_latched() ? GetParam().row.severity : Severity::kNone);
}

TEST_P(EachRow, IsAcknowledgedOnlyWhereItsSymptomIsGone) {
  fire();
  EXPECT_EQ(drill_.reactions.acknowledge(), GetParam().row.severity) << "the cause is there";
  EXPECT_EQ(severity(), GetParam().row.severity);
  for (Time healthy{0}; healthy <= info_of(GetParam().row.symptom).clears; healthy += kTick) {
    shown(false);
  }
  EXPECT_EQ(drill_.reactions.acknowledge(), Severity::kNone);
  EXPECT_EQ(severity(), Severity::kNone);
  shown(false);
  EXPECT_EQ(severity(), Severity::kNone);
}

TEST_P(EachRow, AFaultThatTogglesEscalatesAllTheSame) {
  // Every other tick.
  for (std::int64_t i = 1; i < ticks_until_due(); ++i) {
    ASSERT_LE(shown(true), GetParam().before);
    shown(false);
  }
  EXPECT_EQ(shown(true), GetParam().row.severity);
}

TEST_P(EachRow, IsForgottenAfterItsTimeInHealth) {
  if (ticks_until_due() == 1) {
    return;  // nothing accrues
  }
  for (std::int64_t i = 1; i < ticks_until_due(); ++i) {
    shown(true);
  }
  const Severity before = severity();
  for (Time healthy{0}; healthy < info_of(GetParam().row.symptom).forgets; healthy += kTick) {
    shown(false);
  }
  drill_.reactions.acknowledge();
  for (std::int64_t i = 1; i < ticks_until_due(); ++i) {
    ASSERT_LE(shown(true), before);
  }
  EXPECT_EQ(shown(true), GetParam().row.severity);
}

INSTANTIATE_TEST_SUITE_P(FaultTable, EachRow, ::testing::ValuesIn(cases()), [](const auto& row) {
  return std::string(info_of(row.param.row.symptom).name) + "_" + std::to_string(row.param.index);
});

}  // namespace
}  // namespace mayfly::test
