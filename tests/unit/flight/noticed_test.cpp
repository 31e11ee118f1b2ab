// How soon a fault is seen and answered, by the events of its flight.
#include "controller/flight/noticed.hpp"

#include <gtest/gtest.h>

#include "controller/safety/reaction_table.hpp"

namespace mayfly::test {
namespace {

Scenario with_silent(std::initializer_list<std::pair<std::size_t, double>> struck) {
  Scenario scenario;
  SwarmSpec swarm;
  swarm.name = "flies";
  swarm.count = 5;
  scenario.swarms = {swarm};
  for (const auto& [robot, at] : struck) {
    FaultSpec fault;
    fault.kind = FaultKind::kRobotSilent;
    fault.agents = {{robot, 1}};
    fault.at = at;
    scenario.faults.push_back(fault);
  }
  return scenario;
}

FaultEvent event(double at, const std::string& robot, Symptom symptom, Severity severity) {
  return {at, robot, "sim", std::string(info_of(symptom).cause), std::string(key_of(severity))};
}

TEST(Noticed, IsItsSymptomOfWhomItStrikesAndNotBefore) {
  const Scenario scenario = with_silent({{2, 1.0}});
  EXPECT_FALSE(noticed_after(scenario, FaultKind::kRobotSilent, {}));
  const std::vector<FaultEvent> others{event(0.5, "flies_2", Symptom::kSilent, Severity::kHold),
                                       event(1.1, "flies_3", Symptom::kSilent, Severity::kHold),
                                       event(1.2, "flies_2", Symptom::kStalePose, Severity::kHold)};
  EXPECT_FALSE(noticed_after(scenario, FaultKind::kRobotSilent, others));
  std::vector<FaultEvent> events = others;
  events.push_back(event(1.25, "flies_2", Symptom::kSilent, Severity::kHold));
  EXPECT_DOUBLE_EQ(*noticed_after(scenario, FaultKind::kRobotSilent, events), 0.25);
  EXPECT_FALSE(noticed_after(scenario, FaultKind::kWind, events)) << "there is none";
}

TEST(Noticed, OfSeveralTheLongestCountsAndOneThatIsMissedSpoilsAll) {
  const Scenario scenario = with_silent({{2, 1.0}, {4, 2.0}});
  std::vector<FaultEvent> events{event(1.25, "flies_2", Symptom::kSilent, Severity::kHold)};
  EXPECT_FALSE(noticed_after(scenario, FaultKind::kRobotSilent, events));
  events.push_back(event(2.5, "flies_4", Symptom::kSilent, Severity::kHold));
  EXPECT_DOUBLE_EQ(*noticed_after(scenario, FaultKind::kRobotSilent, events), 0.5);
}

TEST(Reacted, IsAsSevereOrMoreWhateverTheSymptom) {
  const Scenario scenario = with_silent({{2, 1.0}});
  const std::vector<FaultEvent> events{event(1.1, "flies_2", Symptom::kLinkDegraded, Severity::kReport),
                                       event(1.2, "flies_3", Symptom::kSilent, Severity::kLand),
                                       event(1.25, "flies_2", Symptom::kSilent, Severity::kHold),
                                       event(1.5, "", Symptom::kOperatorHold, Severity::kHoldAll)};
  const auto after = [&](Severity least) {
    return reacted_after(scenario, FaultKind::kRobotSilent, least, events);
  };
  EXPECT_NEAR(*after(Severity::kReport), 0.1, 1e-9);
  EXPECT_NEAR(*after(Severity::kHold), 0.25, 1e-9);
  EXPECT_NEAR(*after(Severity::kHoldAll), 0.5, 1e-9) << "of everybody";
  EXPECT_FALSE(after(Severity::kLand)) << "that was another";
}

}  // namespace
}  // namespace mayfly::test
