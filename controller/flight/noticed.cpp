#include "controller/flight/noticed.hpp"

#include <algorithm>
#include <string>

#include "controller/safety/reaction_table.hpp"

namespace mayfly {
namespace {

// "flies_3"
std::string name_of(const Scenario& scenario, std::size_t agent) {
  for (const SwarmSpec& swarm : scenario.swarms) {
    const auto count = static_cast<std::size_t>(swarm.count);
    if (agent < count) {
      return swarm.name + "_" + std::to_string(agent);
    }
    agent -= count;
  }
  return {};
}

bool strikes(const Scenario& scenario, const FaultSpec& fault, const std::string& robot) {
  return std::any_of(fault.agents.begin(), fault.agents.end(), [&](const StruckAgents& struck) {
    for (std::size_t agent = struck.first; agent < struck.first + struck.count; ++agent) {
      if (name_of(scenario, agent) == robot) {
        return true;
      }
    }
    return false;
  });
}

}  // namespace

std::optional<double> noticed_after(const Scenario& scenario, const FaultSpec& fault,
                                    const std::vector<FaultEvent>& events) {
  const Symptom symptom = fault_row(fault.kind).symptom;
  if (symptom == Symptom::kCount) {
    return std::nullopt;
  }
  for (const FaultEvent& event : events) {
    if (event.time_s >= fault.at && event.cause == info_of(symptom).cause &&
        (event.robot.empty() || strikes(scenario, fault, event.robot))) {
      return event.time_s - fault.at;
    }
  }
  return std::nullopt;
}

std::optional<double> noticed_after(const Scenario& scenario, FaultKind kind,
                                    const std::vector<FaultEvent>& events) {
  std::optional<double> longest;
  for (const FaultSpec& fault : scenario.faults) {
    if (fault.kind != kind) {
      continue;
    }
    const auto after = noticed_after(scenario, fault, events);
    if (!after) {
      return std::nullopt;
    }
    longest = std::max(longest.value_or(0.0), *after);
  }
  return longest;
}

}  // namespace mayfly
