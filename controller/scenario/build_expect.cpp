#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "controller/safety/reaction_table.hpp"
#include "controller/scenario/names.hpp"
#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

using Quantity = Expectation::Quantity;

struct QuantityKey {
  const char* name;
  const char* measure;  // where a quantity is a map: the key of its comparison
};

// In the order of Expectation::Quantity.
constexpr std::array<QuantityKey, 28> kQuantities = {{{"reached", "fraction"},
                                                      {"min_separation", nullptr},
                                                      {"penetrations", nullptr},
                                                      {"collisions", nullptr},
                                                      {"mde_percent", nullptr},
                                                      {"max_speed", nullptr},
                                                      {"max_acceleration", nullptr},
                                                      {"governor_interventions", nullptr},
                                                      {"missed", nullptr},
                                                      {"faults", nullptr},
                                                      {"field_age", nullptr},
                                                      {"wall_clearance", nullptr},
                                                      {"drift", "distance"},
                                                      {"goal_distance", "distance"},
                                                      {"turns", "number"},
                                                      {"spread", "radius"},
                                                      {"polarisation", "order"},
                                                      {"milling", "order"},
                                                      {"nearest_neighbour", "distance"},
                                                      {"stimulus_distance", "distance"},
                                                      {"arrived", "fraction"},
                                                      {"clearing", "distance"},
                                                      {"parting", "ratio"},
                                                      {"closing", "ratio"},
                                                      {"noticed", "within"},
                                                      {"infeasible", nullptr},
                                                      {"reacted", "within"},
                                                      {"safety_breaches", nullptr}}};

void read_measure(Expectation& result, const std::string& written) {
  const auto comparison = read_comparison(written);
  result.comparison = comparison->comparison;
  result.wanted = read_number(comparison->number).value.value_or(0.0);
}

// Of what is measured of one swarm: its name, even where the file leaves it out.
std::string build_swarm_name(const Values& values, const Scenario& scenario, Findings& findings) {
  const std::vector<std::string> names = names_of(scenario.swarms);
  if (values.has("swarm")) {
    find_named(values, "swarm", names, "swarm", findings);
    return values.text("swarm");
  }
  if (names.size() != 1) {
    findings.error(values.mark("swarm"), "this does not say which swarm it is about", "",
                   "'swarm: ' and one of " + list_names(names));
  }
  return names.empty() ? std::string() : names.front();
}

// Where somebody has to have a goal.
void check_has_goal(const Values& values, const std::string& name, const Scenario& scenario,
                    Findings& findings) {
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (swarm.name == name && swarm.goal.empty()) {
      findings.error(values.mark("swarm"), fmt::format("swarm '{}' has no goal", name), "",
                     "a swarm with 'goal: '");
    }
  }
}

void build_reached(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  if (values.has("swarm")) {
    find_named(values, "swarm", names_of(scenario.swarms), "swarm", findings);
  }
  if (values.has("goal")) {
    find_named(values, "goal", names_of(scenario.world.goals), "goal", findings);
  }
  result.swarm = values.text("swarm");
  result.goal = values.text("goal");
  check_has_goal(values, result.swarm, scenario, findings);
  if (result.swarm.empty() && std::all_of(scenario.swarms.begin(), scenario.swarms.end(),
                                          [](const SwarmSpec& swarm) { return swarm.goal.empty(); })) {
    findings.error(values.mark("fraction"), "no swarm has a goal", "", "a swarm with 'goal: '");
  }
}

void build_turns(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  if (values.has("around")) {
    result.around = values.vector("around");
    return;
  }
  const std::size_t lamp = find_named(values, "lamp", names_of(scenario.lamps), "lamp", findings);
  result.around = lamp < scenario.lamps.size() ? scenario.lamps[lamp].position : glm::vec3(0.0F);
}

void build_stimulus_name(Expectation& result, const Values& values, const Scenario& scenario,
                         Findings& findings) {
  std::vector<std::string> names = names_of(scenario.lamps);
  for (const StimulusSpec& stimulus : scenario.stimuli) {
    if (stimulus.kind != StimulusSpec::Kind::kAhead) {
      names.push_back(stimulus.name);
    }
  }
  find_named(values, "stimulus", names, "stimulus", findings);
  result.stimulus = values.text("stimulus");
}

void build_arrived(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  result.within = values.number_f("within");
  if (!values.has("at")) {
    return;
  }
  result.at = values.number("at");
  if (*result.at > scenario.duration) {
    findings.error(values.mark("at"), "the run is over by then", fmt::format("{:g} s", *result.at),
                   fmt::format("at most its duration, {:g} s", scenario.duration));
  }
}

// What is measured of one swarm.
void build_motion(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  result.swarm = build_swarm_name(values, scenario, findings);
  if (result.quantity == Quantity::kGoalDistance && values.has("goal")) {
    find_named(values, "goal", names_of(scenario.world.goals), "goal", findings);
    result.goal = values.text("goal");
  } else if (result.quantity == Quantity::kGoalDistance) {
    check_has_goal(values, result.swarm, scenario, findings);
  }
  if (values.has("stimulus")) {
    build_stimulus_name(result, values, scenario, findings);
    result.text += " by " + result.stimulus;
  }
  if (result.quantity == Quantity::kArrived) {
    build_arrived(result, values, scenario, findings);
    result.text += result.at ? fmt::format(" at {:g} s", *result.at) : "";
  }
  if (result.quantity == Quantity::kTurns) {
    build_turns(result, values, scenario, findings);
    result.text += values.has("lamp") ? " around " + values.text("lamp") : "";
  }
}

void build_noticed(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  const FaultRow& row = fault_rows()[static_cast<std::size_t>(values.choice("fault"))];
  result.fault = row.kind;
  result.text += " " + std::string(row.name);
  if (std::none_of(scenario.faults.begin(), scenario.faults.end(),
                   [&](const FaultSpec& fault) { return fault.kind == row.kind; })) {
    findings.error(values.mark("fault"), fmt::format("nothing of the kind '{}' goes wrong", row.name), "",
                   "one of those in 'faults'");
  }
}

void build_reacted(Expectation& result, const Values& values, const Scenario& scenario, Findings& findings) {
  build_noticed(result, values, scenario, findings);
  result.severity = static_cast<Severity>(1 + values.choice("at_least"));
  result.text += fmt::format(" by {}", key_of(result.severity));
}

Expectation build_expectation(const Values& values, const Scenario& scenario, Findings& findings) {
  Expectation result;
  std::size_t which = 0;
  while (!values.has(kQuantities[which].name)) {
    ++which;
  }
  const QuantityKey& key = kQuantities[which];
  result.quantity = static_cast<Quantity>(which);
  result.text = key.name;
  if (key.measure == nullptr) {
    read_measure(result, values.text(key.name));
    return result;
  }
  const Values map = values.map(key.name);
  if (result.quantity == Quantity::kReached) {
    build_reached(result, map, scenario, findings);
  } else if (result.quantity == Quantity::kNoticed) {
    build_noticed(result, map, scenario, findings);
  } else if (result.quantity == Quantity::kReacted) {
    build_reacted(result, map, scenario, findings);
  } else {
    build_motion(result, map, scenario, findings);
  }
  read_measure(result, map.text(key.measure));
  // "turns around street" becomes "turns moths around street".
  const std::size_t end_of_name = std::string_view(key.name).size();
  result.text.insert(end_of_name, result.swarm.empty() ? "" : " " + result.swarm);
  result.text += result.goal.empty() ? "" : " at " + result.goal;
  return result;
}

}  // namespace

std::vector<Expectation> build_expectations(const Values& top, const Scenario& scenario, Findings& findings) {
  std::vector<Expectation> result;
  if (const YamlNode* expect = top.node("expect")) {
    for (const YamlNode& item : expect->items) {
      result.push_back(build_expectation(top.element("expect", item), scenario, findings));
    }
  }
  return result;
}

}  // namespace mayfly
