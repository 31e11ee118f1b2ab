// What goes wrong, as a scenario says it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/unit/scenario/scenario_text.hpp"

namespace mayfly::test {
namespace {

Scenario with_faults(const std::string& lines, const std::string& head = "") {
  auto loaded = load_text(head + kSmallest + "faults:\n" + lines);
  EXPECT_TRUE(loaded) << (loaded ? "" : all_text(loaded.error()));
  return loaded ? *loaded : Scenario{};
}

TEST(Faults, AreNoneUnlessAskedFor) {
  EXPECT_TRUE(load_text(kSmallest)->faults.empty());
}

TEST(Faults, KnowTheirRobots) {
  const Scenario scenario = with_faults(
      "  - {what: robot_silent, robots: flies_3, at: 1, for: 2}\n"
      "  - {what: pose_nan, robots: [flies_1, flies_7]}\n"
      "  - {what: wind, robots: flies, speed: 0.3, direction: [0, 0, -2]}\n"
      "  - {what: tick_gap, at: 4}\n");
  ASSERT_EQ(scenario.faults.size(), 4U);
  const FaultSpec& silent = scenario.faults[0];
  EXPECT_EQ(silent.kind, FaultKind::kRobotSilent);
  ASSERT_EQ(silent.agents.size(), 1U);
  EXPECT_EQ(silent.agents[0].first, 3U);
  EXPECT_EQ(silent.agents[0].count, 1U);
  EXPECT_FALSE(silent.is_on(0.999));
  EXPECT_TRUE(silent.is_on(1.0));
  EXPECT_TRUE(silent.is_on(2.999));
  EXPECT_FALSE(silent.is_on(3.0));
  EXPECT_EQ(scenario.faults[1].agents[1].first, 7U);
  EXPECT_TRUE(std::isinf(scenario.faults[1].length)) << "for ever";
  EXPECT_EQ(scenario.faults[2].agents[0].count, 10U);
  EXPECT_DOUBLE_EQ(scenario.faults[2].size, 0.3);
  EXPECT_FLOAT_EQ(scenario.faults[2].direction.z, -1.0F);
  EXPECT_EQ(scenario.faults[3].agents[0].count, 10U);
}

TEST(Faults, HaveTheSizeOfTheTableWhereNoneIsGiven) {
  for (const FaultRow& row : fault_rows()) {
    const std::string robots =
        row.target == FaultTarget::kPair ? ", robots: [flies_0, flies_1]" : std::string();
    const Scenario scenario = with_faults("  - {what: " + std::string(row.name) + robots + "}\n");
    ASSERT_EQ(scenario.faults.size(), 1U) << row.name;
    EXPECT_EQ(scenario.faults[0].kind, row.kind);
    EXPECT_EQ(scenario.faults[0].size, row.usual_size) << row.name;
    EXPECT_NEAR(glm::length(scenario.faults[0].direction), 1.0F, 1e-6F);
  }
}

TEST(Faults, OneThatComesTooLateIsWarnedOf) {
  EXPECT_TRUE(with_faults("  - {what: tick_gap, at: 59.9}\n").warnings.empty());
  const Scenario late = with_faults("  - {what: tick_gap, at: 60}\n");
  ASSERT_EQ(late.warnings.size(), 1U);
  EXPECT_NE(late.warnings[0].message.find("when the run of 60 s is over"), std::string::npos);
}

TEST(Faults, ByChanceFollowFromTheSeed) {
  const std::string lines = "  - {random: {count: 40, longest: 3}}\n";
  const Scenario a = with_faults(lines);
  const Scenario b = with_faults(lines);
  const Scenario other = with_faults(lines, "seed: 2\n");
  ASSERT_EQ(a.faults.size(), 40U);
  ASSERT_EQ(other.faults.size(), 40U);
  int differ = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    const FaultSpec& fault = a.faults[i];
    EXPECT_EQ(fault.kind, b.faults[i].kind);
    EXPECT_EQ(fault.at, b.faults[i].at);
    EXPECT_EQ(fault.direction.x, b.faults[i].direction.x);
    differ += fault.at != other.faults[i].at ? 1 : 0;
    EXPECT_GE(fault.at, 0.0);
    EXPECT_LT(fault.at, 60.0);
    EXPECT_GT(fault.length, 0.0);
    EXPECT_LE(fault.length, 3.0);
    EXPECT_NE(fault_row(fault.kind).place, FaultPlace::kOperator) << "that would end the flight";
    if (fault_row(fault.kind).target == FaultTarget::kPair) {
      ASSERT_EQ(fault.agents.size(), 2U);
      EXPECT_NE(fault.agents[0].first, fault.agents[1].first);
    }
  }
  EXPECT_GT(differ, 30);
}

TEST(Faults, ByChanceAreOfTheKindsThatAreNamed) {
  const Scenario scenario = with_faults("  - {random: {what: [wind, pose_nan], count: 50}}\n");
  const auto of = [&](FaultKind kind) {
    return std::count_if(scenario.faults.begin(), scenario.faults.end(),
                         [&](const FaultSpec& fault) { return fault.kind == kind; });
  };
  EXPECT_EQ(of(FaultKind::kWind) + of(FaultKind::kPoseNan), 50);
  EXPECT_GT(of(FaultKind::kWind), 5);
  EXPECT_GT(of(FaultKind::kPoseNan), 5);
}

}  // namespace
}  // namespace mayfly::test
