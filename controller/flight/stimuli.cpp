#include "controller/flight/stimuli.hpp"

#include <algorithm>

namespace mayfly {
namespace {

using Kind = StimulusSpec::Kind;

template <class Spec>
bool is_felt(const Spec& spec, const SwarmSpec& swarm) {
  return swarm.model == Model::kForces && (spec.swarm.empty() || spec.swarm == swarm.name);
}

kernels::MfStimulus kernel_stimulus(const StimulusSpec& spec) {
  const int kind = spec.kind == Kind::kPredator ? MF_STIMULUS_PREDATOR
                   : spec.kind == Kind::kAhead  ? MF_STIMULUS_AHEAD
                                                : MF_STIMULUS_PREY;
  const glm::vec3 at = spec.position_at(0.0);
  return {kind, at.x, at.y, at.z, spec.weight, spec.reach, spec.distance, spec.turn};
}

}  // namespace

void add_stimuli(const Scenario& scenario, const SwarmSpec& swarm, kernels::MfForces& forces) {
  forces.stimuli = 0;
  const auto add = [&](const kernels::MfStimulus& stimulus) {
    if (forces.stimuli < MF_MAX_STIMULI) {
      forces.stimulus[forces.stimuli++] = stimulus;
    }
  };
  for (const LampSpec& lamp : scenario.lamps) {
    if (is_felt(lamp, swarm)) {
      const glm::vec3 at = lamp.position;
      add({MF_STIMULUS_PREY, at.x, at.y, at.z, lamp.weight, lamp.reach, 0.0F, 0.0F});
    }
  }
  for (const StimulusSpec& spec : scenario.stimuli) {
    if (is_felt(spec, swarm)) {
      add(kernel_stimulus(spec));
    }
  }
}

MovingStimuli::MovingStimuli(const Scenario& scenario) {
  for (std::size_t s = 0; s < scenario.swarms.size(); ++s) {
    Swarm swarm{s, {}, {}};
    bool moves = false;
    for (const LampSpec& lamp : scenario.lamps) {
      if (is_felt(lamp, scenario.swarms[s])) {
        swarm.specs.push_back(nullptr);
        swarm.places.push_back(lamp.position);
      }
    }
    for (const StimulusSpec& spec : scenario.stimuli) {
      if (is_felt(spec, scenario.swarms[s])) {
        swarm.specs.push_back(spec.path ? &spec : nullptr);
        swarm.places.push_back(spec.position);
        moves = moves || spec.path;
      }
    }
    if (moves) {
      swarms_.push_back(std::move(swarm));
    }
  }
}

void MovingStimuli::move(double time_s, Engine& engine) noexcept {
  for (Swarm& swarm : swarms_) {
    for (std::size_t i = 0; i < swarm.specs.size(); ++i) {
      if (swarm.specs[i] != nullptr) {
        swarm.places[i] = swarm.specs[i]->position_at(time_s);
      }
    }
    engine.move_stimuli(swarm.index, swarm.places);
  }
}

std::optional<NamedStimulus> stimulus_named(const Scenario& scenario, const std::string& name) {
  for (const LampSpec& lamp : scenario.lamps) {
    if (lamp.name == name) {
      return NamedStimulus{nullptr, lamp.position, lamp.reach};
    }
  }
  for (const StimulusSpec& spec : scenario.stimuli) {
    if (spec.name == name && spec.kind != Kind::kAhead) {
      return NamedStimulus{&spec, spec.position, spec.reach};
    }
  }
  return std::nullopt;
}

}  // namespace mayfly
