#include "controller/flight/kernel_parts.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {
namespace {

// The rms of |∇ × P| for scale = gain = 1 (model.md §1).
constexpr float kCurlSpeed = 1.718F;

int kernel_kind(NoiseKind kind) {
  switch (kind) {
    case NoiseKind::kPerlin:
      return MF_NOISE_PERLIN;
    case NoiseKind::kWhite:
      return MF_NOISE_WHITE;
    case NoiseKind::kGaussian:
      return MF_NOISE_GAUSSIAN;
    default:
      return MF_NOISE_CURL;
  }
}

bool is_for(const std::string& named, const SwarmSpec& swarm) {
  return named.empty() || named == swarm.name;
}

std::vector<kernels::MfPull> pulls_of(const Scenario& scenario, const SwarmSpec& swarm) {
  std::vector<kernels::MfPull> pulls;
  if (!swarm.is_guided()) {
    return pulls;
  }
  for (const LampSpec& lamp : scenario.lamps) {
    if (is_for(lamp.swarm, swarm)) {
      const glm::vec3 at = lamp.position;
      pulls.push_back({MF_PULL_LAMP, at.x, at.y, at.z, lamp.reach, lamp.speed, lamp.probability});
    }
  }
  for (const BrushSpec& brush : scenario.world.brushes) {
    if (brush.term == BrushSpec::Term::kPotential && is_for(brush.swarm, swarm)) {
      const glm::vec3 at = brush.center;
      const float sign = brush.effect == BrushSpec::Effect::kAttract ? 1.0F : -1.0F;
      pulls.push_back({MF_PULL_BRUSH, at.x, at.y, at.z, brush.radius, sign * brush.strength, 0.0F});
    }
  }
  return pulls;
}

}  // namespace

kernels::MfNoise kernel_noise(const NoiseSpec& spec, std::uint32_t seed) {
  kernels::MfNoise noise{};
  noise.kind = kernel_kind(spec.kind);
  noise.octaves = static_cast<int>(std::min<std::size_t>(spec.octaves.size(), MF_MAX_OCTAVES));
  noise.permuted = spec.hash == NoiseHash::kPerlin2002 ? 1 : 0;
  noise.seed = seed;
  noise.drift = spec.drift;
  float speed2 = 0.0F;  // octaves know nothing of each other: their squares add
  for (std::size_t o = 0; o < static_cast<std::size_t>(noise.octaves); ++o) {
    noise.inverse_scale[o] = 1.0F / spec.octaves[o].scale;
    noise.gain[o] = spec.octaves[o].gain;
    const float speed = kCurlSpeed * noise.gain[o] * noise.inverse_scale[o];
    speed2 += speed * speed;
  }
  noise.rms_speed = std::sqrt(speed2);
  return noise;
}

void add_pulls(const Scenario& scenario, const SwarmSpec& swarm, kernels::MfField& field) {
  const auto pulls = pulls_of(scenario, swarm);
  field.pulls = static_cast<int>(std::min<std::size_t>(pulls.size(), MF_MAX_PULLS));
  std::copy_n(pulls.begin(), field.pulls, field.pull);
}

std::vector<Error> excess_pulls(const Scenario& scenario) {
  std::vector<Error> errors;
  for (const SwarmSpec& swarm : scenario.swarms) {
    const std::size_t count = pulls_of(scenario, swarm).size();
    if (count > MF_MAX_PULLS) {
      errors.push_back({.message = "swarm '" + swarm.name + "' has too many lamps and potential brushes",
                        .place = swarm.place,
                        .found = std::to_string(count),
                        .wanted = "at most " + std::to_string(MF_MAX_PULLS) +
                                  "; name a swarm in those that are not meant for all"});
    }
  }
  return errors;
}

}  // namespace mayfly
