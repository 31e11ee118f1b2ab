// Lamps, predators, food, mates, and what moves ahead of each agent.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>
#include <utility>

#include "controller/scenario/names.hpp"

namespace mayfly {
namespace {

using Kind = StimulusSpec::Kind;

// Of one swarm that forces drive; a flight refuses more (MF_MAX_STIMULI).
constexpr std::size_t kMaxStimuli = 8;

constexpr std::array kKinds{std::pair{"predator", Kind::kPredator}, std::pair{"food", Kind::kFood},
                            std::pair{"mate", Kind::kMate}, std::pair{"ahead", Kind::kAhead}};

bool feels(const SwarmSpec& swarm, const std::string& named) {
  return named.empty() || named == swarm.name;
}

// Of a name that was refused nothing more needs to be said.
bool is_known(const std::string& named, const Scenario& scenario) {
  return std::any_of(scenario.swarms.begin(), scenario.swarms.end(),
                     [&](const SwarmSpec& swarm) { return feels(swarm, named); });
}

// What a lamp needs depends on who sees it.
void check_lamp(const Values& lamp, const LampSpec& spec, const Scenario& scenario, Findings& findings) {
  const auto seen_by = [&](auto&& is_such) {
    return std::any_of(scenario.swarms.begin(), scenario.swarms.end(),
                       [&](const SwarmSpec& swarm) { return feels(swarm, spec.swarm) && is_such(swarm); });
  };
  const auto needs = [&](const char* key, const char* wanted) {
    if (!lamp.has(key)) {
      findings.error(lamp.mark(key), fmt::format("the key '{}' is missing in stimuli[].lamp", key), "",
                     wanted);
    }
  };
  const bool led = seen_by([](const SwarmSpec& swarm) { return swarm.is_guided(); });
  const bool driven = seen_by([](const SwarmSpec& swarm) { return swarm.model == Model::kForces; });
  if (led) {
    needs("speed", "a velocity in m/s, because fields lead who sees it");
    needs("probability", "a number from 0 to 1, because fields lead who sees it");
  }
  if (driven) {
    needs("weight", "a force in m/s², because forces drive who sees it");
  }
  if (!led && !driven && is_known(spec.swarm, scenario)) {
    findings.error(lamp.mark("name"), fmt::format("nobody sees lamp '{}'", spec.name), "",
                   "a swarm of the model field, orca or forces");
  }
}

LampSpec build_lamp(const Values& values, const Scenario& scenario, Findings& findings) {
  const Values lamp = values.map("lamp");
  LampSpec spec;
  spec.name = lamp.text("name");
  spec.position = lamp.vector("position");
  spec.reach = lamp.number_f("reach");
  spec.speed = lamp.number_f("speed");
  spec.probability = lamp.number_f("probability");
  spec.weight = lamp.number_f("weight");
  spec.swarm = swarm_of(values, scenario, findings);
  spec.place = values.mark("lamp").place();
  check_reaches(lamp.mark("position"), "lamp", spec.position, spec.reach, scenario.world.bounds, findings);
  check_lamp(lamp, spec, scenario, findings);
  return spec;
}

// Only forces know of the others.
void check_felt(const YamlMark& mark, const StimulusSpec& spec, const char* kind, const Scenario& scenario,
                Findings& findings) {
  if (is_known(spec.swarm, scenario) &&
      std::none_of(scenario.swarms.begin(), scenario.swarms.end(), [&](const SwarmSpec& swarm) {
        return swarm.model == Model::kForces && feels(swarm, spec.swarm);
      })) {
    findings.error(mark,
                   spec.swarm.empty()
                       ? fmt::format("nobody feels this '{}': no swarm has the model forces", kind)
                       : fmt::format("swarm '{}' does not feel this '{}'", spec.swarm, kind),
                   "", "a swarm of the model forces");
  }
}

StimulusSpec build_stimulus(const Values& values, const std::pair<const char*, Kind>& kind,
                            const Scenario& scenario, Findings& findings) {
  const Values own = values.map(kind.first);
  StimulusSpec spec;
  spec.kind = kind.second;
  spec.reach = own.number_f("reach");
  spec.weight = own.number_f("weight");
  spec.swarm = swarm_of(values, scenario, findings);
  spec.place = values.mark(kind.first).place();
  check_felt(values.mark(kind.first), spec, kind.first, scenario, findings);
  if (spec.kind == Kind::kAhead) {
    spec.distance = own.number_f("distance");
    spec.turn = glm::radians(own.number_f("turn"));
    if (spec.reach < spec.distance) {
      findings.error(own.mark("reach"), "nobody feels what is farther ahead than it reaches",
                     fmt::format("reach {:g} and distance {:g}", spec.reach, spec.distance),
                     "a reach of at least the distance");
    }
    return spec;
  }
  spec.name = own.text("name");
  spec.position = own.vector("position");
  spec.path = build_path(own, findings);
  if (!spec.path) {
    check_reaches(own.mark("position"), kind.first, spec.position, spec.reach, scenario.world.bounds,
                  findings);
  }
  return spec;
}

void check_number(const Scenario& scenario, const Stimuli& stimuli, Findings& findings) {
  for (const SwarmSpec& swarm : scenario.swarms) {
    std::vector<Place> places;
    const auto add = [&](const auto& spec) {
      if (swarm.model == Model::kForces && feels(swarm, spec.swarm)) {
        places.push_back(spec.place);
      }
    };
    std::for_each(stimuli.lamps.begin(), stimuli.lamps.end(), add);
    std::for_each(stimuli.others.begin(), stimuli.others.end(), add);
    if (places.size() > kMaxStimuli) {
      findings.error(places[kMaxStimuli], fmt::format("swarm '{}' feels too many stimuli", swarm.name),
                     fmt::format("{}", places.size()), fmt::format("at most {}", kMaxStimuli));
    }
  }
}

}  // namespace

Stimuli build_stimuli(const Values& top, const Scenario& scenario, Findings& findings) {
  Stimuli stimuli;
  UniqueNames names("stimulus");
  const YamlNode* node = top.node("stimuli");
  if (node == nullptr) {
    return stimuli;
  }
  for (const YamlNode& item : node->items) {
    const Values values = top.element("stimuli", item);
    if (values.has("lamp")) {
      stimuli.lamps.push_back(build_lamp(values, scenario, findings));
      names.add(values.map("lamp"), findings);
      continue;
    }
    const auto kind = *std::find_if(kKinds.begin(), kKinds.end(),
                                    [&](const auto& known) { return values.has(known.first); });
    stimuli.others.push_back(build_stimulus(values, kind, scenario, findings));
    if (kind.second != Kind::kAhead) {
      names.add(values.map(kind.first), findings);
    }
  }
  check_number(scenario, stimuli, findings);
  return stimuli;
}

}  // namespace mayfly
