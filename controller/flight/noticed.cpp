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

// Of the first event that is about the fault, from its begin on.
template <class IsIt>
std::optional<double> first_after(const Scenario& scenario, const FaultSpec& fault,
                                  const std::vector<FaultEvent>& events, const IsIt& is_it) {
  for (const FaultEvent& event : events) {
    if (event.time_s >= fault.at && is_it(event) &&
        (event.robot.empty() || strikes(scenario, fault, event.robot))) {
      return event.time_s - fault.at;
    }
  }
  return std::nullopt;
}

template <class After>
std::optional<double> longest_of(const Scenario& scenario, FaultKind kind, const After& after) {
  std::optional<double> longest;
  for (const FaultSpec& fault : scenario.faults) {
    if (fault.kind != kind) {
      continue;
    }
    const std::optional<double> took = after(fault);
    if (!took) {
      return std::nullopt;
    }
    longest = std::max(longest.value_or(0.0), *took);
  }
  return longest;
}

bool is_at_least(const FaultEvent& event, Severity least) {
  for (auto s = static_cast<std::size_t>(least); s < kSeverities; ++s) {
    if (event.severity == key_of(static_cast<Severity>(s))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<double> noticed_after(const Scenario& scenario, const FaultSpec& fault,
                                    const std::vector<FaultEvent>& events) {
  const std::string_view cause = info_of(fault_row(fault.kind).symptom).cause;
  return first_after(scenario, fault, events, [&](const FaultEvent& event) { return event.cause == cause; });
}

std::optional<double> noticed_after(const Scenario& scenario, FaultKind kind,
                                    const std::vector<FaultEvent>& events) {
  return longest_of(scenario, kind,
                    [&](const FaultSpec& fault) { return noticed_after(scenario, fault, events); });
}

std::optional<double> reacted_after(const Scenario& scenario, const FaultSpec& fault, Severity at_least,
                                    const std::vector<FaultEvent>& events) {
  return first_after(scenario, fault, events,
                     [&](const FaultEvent& event) { return is_at_least(event, at_least); });
}

std::optional<double> reacted_after(const Scenario& scenario, FaultKind kind, Severity at_least,
                                    const std::vector<FaultEvent>& events) {
  return longest_of(scenario, kind,
                    [&](const FaultSpec& fault) { return reacted_after(scenario, fault, at_least, events); });
}

}  // namespace mayfly
