// What moves a swarm where fields alone do not, collision avoidance, and who of the swarm is there.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/scenario/build.hpp"

namespace mayfly {
namespace {

// Agents per unit volume at a temperature in °C (Ren16 Eq. 1).
double natural_density(double temperature) {
  return -0.1073 * temperature * temperature + 4.7643 * temperature - 33.4556;
}

// By how much insects keep farther from each other than at the temperature that radii are given for.
float room_factor(const Values& values) {
  constexpr double kReference = 25.0;  // °C
  const auto temperature = values.maybe_number("temperature");
  return temperature ? static_cast<float>(std::cbrt(natural_density(kReference) /
                                                    natural_density(static_cast<double>(*temperature))))
                     : 1.0F;
}

// Of a zone that is not the innermost; the papers' own tables have such weights.
void check_zone(const Values& forces, const char* zone, float weight, float width, Findings& findings) {
  if (weight > 0.0F && width == 0.0F && forces.has(zone)) {
    findings.warn(forces.mark(zone),
                  fmt::format("a zone of width 0 holds nobody: the weight of '{}' does nothing", zone));
  }
}

ForcesSpec build_forces(const Values& forces, float factor, Findings& findings) {
  const Values repulsion = forces.map("repulsion");
  const Values alignment = forces.map("alignment");
  const Values attraction = forces.map("attraction");
  const float alignment_width = alignment.number_f("width");
  const float attraction_width = attraction.number_f("width");
  ForcesSpec spec;
  spec.friction = forces.number_f("friction");
  spec.repulsion_weight = repulsion.number_f("weight");
  spec.repulsion_radius = factor * repulsion.number_f("radius");
  spec.alignment_weight = alignment.number_f("weight");
  spec.alignment_radius = spec.repulsion_radius + factor * alignment_width;
  spec.attraction_weight = attraction.number_f("weight");
  spec.attraction_radius = spec.alignment_radius + factor * attraction_width;
  spec.far_error = forces.number_f("far_error");
  if (spec.repulsion_weight > 0.0F && spec.repulsion_radius == 0.0F) {
    findings.error(repulsion.mark("radius"), "a repulsion with a radius of 0 repels nobody", "",
                   "a radius above 0, or 'weight: 0'");
  }
  check_zone(forces, "alignment", spec.alignment_weight, alignment_width, findings);
  check_zone(forces, "attraction", spec.attraction_weight, attraction_width, findings);
  return spec;
}

BoidsSpec build_boids(const Values& boids, float factor, float most_speed, Findings& findings) {
  BoidsSpec spec;
  spec.separation_weight = boids.map("separation").number_f("weight");
  spec.separation_radius = factor * boids.map("separation").number_f("radius");
  spec.alignment_weight = boids.map("alignment").number_f("weight");
  spec.alignment_radius = factor * boids.map("alignment").number_f("radius");
  spec.cohesion_weight = boids.map("cohesion").number_f("weight");
  spec.cohesion_radius = factor * boids.map("cohesion").number_f("radius");
  spec.speed = boids.number_f("speed");
  if (spec.speed > most_speed && boids.has("speed")) {
    findings.error(boids.mark("speed"), "the boids' speed is above the speed limit",
                   fmt::format("speed {:g} and limits.speed {:g}", spec.speed, most_speed),
                   "a speed of at most the limit");
  }
  spec.speed = std::min(spec.speed, most_speed);
  return spec;
}

BrownianSpec build_brownian(const Values& brownian, const fields::Shape& start) {
  BrownianSpec spec;
  spec.friction = brownian.number_f("friction");
  spec.intake = brownian.number_f("intake");
  spec.dissipation = brownian.number_f("dissipation");
  spec.conversion = brownian.number_f("conversion");
  spec.noise = brownian.number_f("noise");
  spec.pull = brownian.number_f("pull");
  const Box box = box_around(start).value_or(Box{});
  spec.center = brownian.has("center") ? brownian.vector("center") : 0.5F * (box.min + box.max);
  return spec;
}

AvoidanceSpec build_avoidance(const Values& avoidance, const SwarmSpec& swarm) {
  AvoidanceSpec spec;
  const bool avoids_by_default = swarm.model == Model::kForces || swarm.model == Model::kOrca;
  spec.on = avoidance.has("kind") ? avoidance.choice("kind") == 0 : avoids_by_default;
  spec.horizon = avoidance.number_f("horizon");
  spec.wall_horizon = avoidance.number_f("wall_horizon");
  const float apart = std::max(swarm.limits.separation, 2.0F * swarm.radius);
  spec.range = avoidance.maybe_number("range").value_or(apart + 2.0F * swarm.limits.speed * spec.horizon);
  spec.neighbours = static_cast<int>(avoidance.integer("neighbours"));
  spec.strict = avoidance.flag("strict");
  return spec;
}

// A model's own keys without the model are a slip that nothing else would show.
void check_model_keys(const Values& values, const SwarmSpec& swarm, Findings& findings) {
  constexpr std::array kOwn{std::pair{"forces", Model::kForces}, std::pair{"boids", Model::kBoids},
                            std::pair{"brownian", Model::kBrownian}};
  for (const auto& [key, model] : kOwn) {
    if (values.has(key) && swarm.model != model) {
      findings.warn(values.mark(key),
                    fmt::format("'{}' does nothing: the model of swarm '{}' is another", key, swarm.name));
    }
  }
  if (values.has("temperature") && swarm.model != Model::kForces && swarm.model != Model::kBoids) {
    findings.warn(values.mark("temperature"),
                  fmt::format("the model of swarm '{}' has no zones that a temperature scales", swarm.name));
  }
  if (swarm.model == Model::kOrca && !swarm.avoidance.on) {
    findings.error(values.map("avoidance").mark("kind"), "the model 'orca' is collision avoidance alone",
                   "avoidance: {kind: none}", "another model, or no 'kind'");
  }
}

}  // namespace

void build_models(const Values& values, SwarmSpec& swarm, Findings& findings) {
  swarm.model = std::array{Model::kField, Model::kForces, Model::kBoids, Model::kOrca,
                           Model::kBrownian}[static_cast<std::size_t>(values.choice("model"))];
  const float factor = room_factor(values);
  swarm.forces = build_forces(values.map("forces"), factor, findings);
  swarm.boids = build_boids(values.map("boids"), factor, swarm.limits.speed, findings);
  swarm.brownian = build_brownian(values.map("brownian"), swarm.start);
  swarm.avoidance = build_avoidance(values.map("avoidance"), swarm);
  if (swarm.model == Model::kOrca) {
    swarm.noise.kind = NoiseKind::kNone;
  }
  check_model_keys(values, swarm, findings);
}

void build_roster(const Values& values, SwarmSpec& swarm, Findings& findings) {
  const auto at_most_all = [&](const Values& map, const char* key, int agents, const char* message) {
    if (agents > swarm.count) {
      findings.error(map.mark(key), fmt::format("{} than swarm '{}' has", message, swarm.name),
                     fmt::format("{} of {}", agents, swarm.count), fmt::format("at most {}", swarm.count));
    }
  };
  if (values.has("join")) {
    const Values join = values.map("join");
    swarm.join = JoinSpec{static_cast<int>(join.integer("first")), join.number_f("rate")};
    at_most_all(join, "first", swarm.join->first, "more agents are there at the start");
  }
  if (values.has("leave")) {
    const Values leave = values.map("leave");
    swarm.leave =
        LeaveSpec{leave.number_f("after"), leave.number_f("rate"), static_cast<int>(leave.integer("count"))};
    at_most_all(leave, "count", swarm.leave->count, "more agents leave");
  }
}

}  // namespace mayfly
