#include "controller/flight/stimuli.hpp"

#include <utility>

namespace mayfly {
namespace {

using Kind = StimulusSpec::Kind;

// What a swarm may feel; one of the two is null.
struct Felt {
  const LampSpec* lamp = nullptr;
  const StimulusSpec* other = nullptr;
};

// In the order in which the engine knows them: lamps, then the others.
std::vector<Felt> felt_by(const Scenario& scenario, const SwarmSpec& swarm) {
  std::vector<Felt> felt;
  if (swarm.model != Model::kForces) {
    return felt;
  }
  const auto is_meant = [&](const std::string& name) { return name.empty() || name == swarm.name; };
  for (const LampSpec& lamp : scenario.lamps) {
    if (is_meant(lamp.swarm)) {
      felt.push_back({&lamp, nullptr});
    }
  }
  for (const StimulusSpec& spec : scenario.stimuli) {
    if (is_meant(spec.swarm)) {
      felt.push_back({nullptr, &spec});
    }
  }
  return felt;
}

kernels::MfStimulus kernel_stimulus(const LampSpec& lamp) {
  const glm::vec3 at = lamp.position;
  return {MF_STIMULUS_PREY, at.x, at.y, at.z, lamp.weight, lamp.reach, 0.0F, 0.0F};
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
  for (const auto& [lamp, other] : felt_by(scenario, swarm)) {
    if (forces.stimuli < MF_MAX_STIMULI) {
      forces.stimulus[forces.stimuli++] = lamp != nullptr ? kernel_stimulus(*lamp) : kernel_stimulus(*other);
    }
  }
}

MovingStimuli::MovingStimuli(const Scenario& scenario) {
  for (std::size_t s = 0; s < scenario.swarms.size(); ++s) {
    Swarm swarm{s, {}, {}};
    bool moves = false;
    for (const auto& [lamp, other] : felt_by(scenario, scenario.swarms[s])) {
      const bool has_path = other != nullptr && other->path;
      swarm.specs.push_back(has_path ? other : nullptr);
      swarm.places.push_back(lamp != nullptr ? lamp->position : other->position);
      moves = moves || has_path;
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
