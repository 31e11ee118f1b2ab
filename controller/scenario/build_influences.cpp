// Brushes: what draws agents or keeps them away, beside obstacles and goals; and what they share with
// stimuli.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "controller/scenario/names.hpp"

namespace mayfly {
namespace {

// Lamps and potential brushes of one swarm; a flight refuses more (MF_MAX_PULLS).
constexpr std::size_t kMaxPulls = 16;

BrushSpec build_brush(const Values& values, const Scenario& scenario, Findings& findings) {
  const bool attracts = values.has("attract");
  const char* effect = attracts ? "attract" : "repel";
  const Values brush = values.map(effect);
  BrushSpec spec;
  spec.effect = attracts ? BrushSpec::Effect::kAttract : BrushSpec::Effect::kRepel;
  spec.term = std::array{BrushSpec::Term::kCost,
                         BrushSpec::Term::kPotential}[static_cast<std::size_t>(brush.choice("term"))];
  spec.center = brush.vector("center");
  spec.radius = brush.number_f("radius");
  spec.strength = brush.number_f("strength");
  spec.swarm = swarm_of(values, scenario, findings);
  spec.place = values.mark(effect).place();
  check_reaches(values.mark(effect), "brush", spec.center, spec.radius, scenario.world.bounds, findings);
  if (spec.term == BrushSpec::Term::kCost && spec.radius < scenario.world.cell) {
    findings.warn(brush.mark("radius"),
                  fmt::format("a brush of {:g} m may fall between cells of {:g} m, and do nothing",
                              spec.radius, scenario.world.cell));
  }
  return spec;
}

// The cost of a metre stays above 0 everywhere (fields::kLeastSlowness), whatever is taken away from it.
void check_attraction(const Values& values, const BrushSpec& brush, const Scenario& scenario,
                      Findings& findings) {
  constexpr float kMost = 0.9F;  // of the length weight
  if (brush.effect != BrushSpec::Effect::kAttract || brush.term != BrushSpec::Term::kCost) {
    return;
  }
  for (const SwarmSpec& swarm : scenario.swarms) {
    const bool feels = brush.swarm.empty() || brush.swarm == swarm.name;
    if (feels && brush.strength > kMost * swarm.cost.length_weight) {
      findings.warn(values.map("attract").mark("strength"),
                    fmt::format("a metre costs swarm '{}' {:g} and at least a tenth of that: this brush "
                                "takes away no more than {:g}",
                                swarm.name, swarm.cost.length_weight, kMost * swarm.cost.length_weight));
    }
  }
}

}  // namespace

std::string swarm_of(const Values& values, const Scenario& scenario, Findings& findings) {
  if (values.has("swarm")) {
    find_named(values, "swarm", names_of(scenario.swarms), "swarm", findings);
  }
  return values.text("swarm");
}

void check_reaches(const YamlMark& mark, const char* what, glm::vec3 center, float reach, const Box& bounds,
                   Findings& findings) {
  const glm::vec3 nearest = glm::clamp(center, bounds.min, bounds.max);
  if (glm::distance(nearest, center) >= reach) {
    findings.error(mark, fmt::format("this {} does not reach into world.bounds", what), "",
                   "one that agents can feel");
  }
}

std::vector<BrushSpec> build_brushes(const Values& world, const Scenario& scenario, Findings& findings) {
  std::vector<BrushSpec> brushes;
  if (const YamlNode* node = world.node("brushes")) {
    for (const YamlNode& item : node->items) {
      const Values values = world.element("brushes", item);
      brushes.push_back(build_brush(values, scenario, findings));
      check_attraction(values, brushes.back(), scenario, findings);
    }
  }
  return brushes;
}

void check_pulls(const Scenario& scenario, Findings& findings) {
  for (const SwarmSpec& swarm : scenario.swarms) {
    if (!swarm.is_guided()) {
      continue;
    }
    const auto feels = [&](const auto& spec) { return spec.swarm.empty() || spec.swarm == swarm.name; };
    std::vector<Place> places;
    for (const BrushSpec& brush : scenario.world.brushes) {
      if (brush.term == BrushSpec::Term::kPotential && feels(brush)) {
        places.push_back(brush.place);
      }
    }
    for (const LampSpec& lamp : scenario.lamps) {
      if (feels(lamp)) {
        places.push_back(lamp.place);
      }
    }
    if (places.size() > kMaxPulls) {
      findings.error(places[kMaxPulls],
                     fmt::format("swarm '{}' feels too many lamps and potential brushes", swarm.name),
                     fmt::format("{}", places.size()), fmt::format("at most {}", kMaxPulls));
    }
  }
}

}  // namespace mayfly
