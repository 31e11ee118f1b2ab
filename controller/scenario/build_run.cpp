#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/scenario/build.hpp"
#include "controller/scenario/numbers.hpp"
#include "controller/scenario/suggest.hpp"

namespace mayfly {
namespace {

constexpr double kLeastPlantRate = 200.0;  // Hz; slower plants show their steps

SimHalSpec build_sim(const Values& values, float control_rate, Findings& findings) {
  SimHalSpec sim;
  sim.plant = std::array{PlantKind::kIdeal, PlantKind::kVelocityLag,
                         PlantKind::kDoubleIntegrator}[static_cast<std::size_t>(values.choice("plant"))];
  sim.time_constant = values.number_f("time_constant");
  const double steps = std::max(1.0, std::ceil(kLeastPlantRate / static_cast<double>(control_rate)));
  sim.rate =
      values.maybe_number("rate").value_or(static_cast<float>(steps * static_cast<double>(control_rate)));
  sim.pose_noise = values.number_f("pose_noise");
  sim.delay = values.number_f("delay");
  sim.dropout = values.number_f("dropout");
  sim.freeze = values.number_f("freeze");
  sim.freeze_time = values.number_f("freeze_time");
  sim.nan = values.number_f("nan");
  if (sim.rate < control_rate) {
    findings.error(values.mark("rate"), "the plant would be stepped more slowly than it is controlled",
                   fmt::format("{:g} Hz", sim.rate),
                   fmt::format("at least control.rate, {:g} Hz", control_rate));
  } else if (std::remainder(sim.rate, control_rate) != 0.0F) {
    findings.warn(values.mark("rate"),
                  fmt::format("a plant rate of {:g} Hz is no multiple of control.rate ({:g} Hz)", sim.rate,
                              control_rate));
  }
  return sim;
}

template <class Specs>
void check_known(const Values& values, const char* key, const Specs& specs, Findings& findings) {
  std::vector<std::string> names;
  names.reserve(specs.size());
  for (const auto& spec : specs) {
    names.push_back(spec.name);
  }
  const std::string name = values.text(key);
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
    findings.error(values.mark(key), fmt::format("there is no {} '{}'", key, name), "",
                   "one of " + list_names(names), nearest_name(name, names));
  }
}

// In the order of Expectation::Quantity.
constexpr std::array<const char*, 10> kQuantities = {
    "reached",   "min_separation",   "penetrations",           "collisions", "mde_percent",
    "max_speed", "max_acceleration", "governor_interventions", "missed",     "faults"};

std::string reached_text(const Expectation& expectation) {
  std::string text = "reached";
  text += expectation.swarm.empty() ? "" : " " + expectation.swarm;
  return text + (expectation.goal.empty() ? "" : " at " + expectation.goal);
}

Expectation build_expectation(const Values& values, const Scenario& scenario, Findings& findings) {
  Expectation result;
  std::size_t which = 0;
  while (!values.has(kQuantities[which])) {
    ++which;
  }
  result.quantity = static_cast<Expectation::Quantity>(which);
  result.text = kQuantities[which];
  std::string written = values.text(kQuantities[which]);
  if (result.quantity == Expectation::Quantity::kReached) {
    const Values reached = values.map("reached");
    check_known(reached, "swarm", scenario.swarms, findings);
    check_known(reached, "goal", scenario.world.goals, findings);
    result.swarm = reached.text("swarm");
    result.goal = reached.text("goal");
    result.text = reached_text(result);
    written = reached.text("fraction");
  }
  const auto comparison = read_comparison(written);
  result.comparison = comparison->comparison;
  result.wanted = read_number(comparison->number).value.value_or(0.0);
  return result;
}

}  // namespace

std::vector<HalSpec> build_hals(const Values& top, float control_rate, Findings& findings) {
  std::vector<HalSpec> hals;
  for (const YamlEntry& entry : top.node("hal")->entries) {
    hals.push_back({entry.key, build_sim(top.element("hal", entry.value), control_rate, findings)});
  }
  return hals;
}

std::vector<Expectation> build_expectations(const Values& top, const Scenario& scenario, Findings& findings) {
  std::vector<Expectation> result;
  if (const YamlNode* expect = top.node("expect")) {
    for (const YamlNode& item : expect->items) {
      result.push_back(build_expectation(top.element("expect", item), scenario, findings));
    }
  }
  return result;
}

std::vector<PlannerSpec> build_planners(const Values& top, Findings& findings) {
  std::vector<PlannerSpec> planners;
  const YamlNode* node = top.node("planners");
  if (node == nullptr) {
    return planners;
  }
  for (const YamlEntry& entry : node->entries) {
    const Values values = top.map("planners").map(entry.key);
    planners.push_back({entry.key, values.number_f("rate"), entry.mark.place()});
    findings.warn(entry.mark,
                  entry.key == "pso"
                      ? "planner 'pso' is not available yet; the run goes on without it"
                      : fmt::format("planner '{}' has no rate of its own yet; noise is evaluated at every "
                                    "control tick",
                                    entry.key));
  }
  return planners;
}

}  // namespace mayfly
