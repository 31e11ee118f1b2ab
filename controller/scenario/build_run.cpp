#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/scenario/build.hpp"

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
  sim.endurance = values.maybe_number("endurance").value_or(0.0F);
  sim.links = static_cast<int>(values.integer("links"));
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

}  // namespace

std::vector<HalSpec> build_hals(const Values& top, float control_rate, Findings& findings) {
  std::vector<HalSpec> hals;
  for (const YamlEntry& entry : top.node("hal")->entries) {
    hals.push_back({entry.key, build_sim(top.element("hal", entry.value), control_rate, findings)});
  }
  return hals;
}

std::vector<PlannerSpec> build_planners(const Values& top, Findings& findings) {
  std::vector<PlannerSpec> planners;
  const YamlNode* node = top.node("planners");
  if (node == nullptr) {
    return planners;
  }
  for (const YamlEntry& entry : node->entries) {
    if (entry.key == "fields") {
      continue;  // Scenario::field_rate
    }
    const Values values = top.map("planners").map(entry.key);
    const float rate = values.number_f("rate");
    planners.push_back({entry.key, rate, std::nullopt, entry.mark.place()});
    if (entry.key == "pso") {
      findings.warn(entry.mark,
                    "planner 'pso' is not available yet, in this version; the run goes on without it");
      continue;
    }
    planners.back().latency = values.maybe_number("latency");
    if (planners.back().latency.value_or(0.0F) * rate > 1.0F + 1e-6F) {
      findings.error(values.mark("latency"), "a plan would be flown after the next one was begun",
                     fmt::format("{:g} s", *planners.back().latency),
                     fmt::format("at most one period, {:g} s", 1.0F / rate));
    }
  }
  return planners;
}

}  // namespace mayfly
