#include "controller/flight/motor_models.hpp"

#include <algorithm>
#include <cmath>

#include "controller/flight/stimuli.hpp"

namespace mayfly {
namespace {

kernels::MfForces kernel_forces(const Scenario& scenario, const SwarmSpec& swarm) {
  const ForcesSpec& spec = swarm.forces;
  kernels::MfForces forces{};
  forces.friction = spec.friction;
  forces.rep_weight = spec.repulsion_weight;
  forces.ali_weight = spec.alignment_weight;
  forces.att_weight = spec.attraction_weight;
  forces.rep_radius = spec.repulsion_radius;
  forces.ali_radius = spec.alignment_radius;
  forces.att_radius = spec.attraction_radius;
  add_stimuli(scenario, swarm, forces);
  return forces;
}

kernels::MfBoids kernel_boids(const BoidsSpec& spec) {
  return {spec.separation_weight,
          spec.alignment_weight,
          spec.cohesion_weight,
          spec.separation_radius,
          spec.alignment_radius,
          spec.cohesion_radius,
          spec.speed};
}

kernels::MfBrownian kernel_brownian(const BrownianSpec& spec) {
  return {spec.friction, spec.intake,   spec.dissipation, spec.conversion, spec.noise,
          spec.pull,     spec.center.x, spec.center.y,    spec.center.z};
}

// Where friction takes as much as the zones give.
float forces_speed(const ForcesSpec& spec, float most) {
  const float drive = spec.repulsion_weight + spec.alignment_weight + spec.attraction_weight;
  return spec.friction > 0.0F ? std::sqrt(drive / spec.friction) : most;
}

// Where the depot gives as much as friction takes: v² = q/γ − c/d (Schweitzer 1998).
float brownian_speed(const BrownianSpec& spec, float most) {
  if (spec.friction <= 0.0F || spec.conversion <= 0.0F) {
    return most;
  }
  return std::sqrt(std::max(0.0F, spec.intake / spec.friction - spec.dissipation / spec.conversion));
}

}  // namespace

float typical_speed(const SwarmSpec& swarm) {
  const float most = swarm.limits.speed;
  switch (swarm.model) {
    case Model::kForces:
      return std::min(most, forces_speed(swarm.forces, most));
    case Model::kBoids:
      return std::min(most, swarm.boids.speed);
    case Model::kBrownian:
      return std::min(most, brownian_speed(swarm.brownian, most));
    case Model::kField:
    case Model::kOrca:
      break;
  }
  return swarm.cruise_speed;
}

void set_motor(const Scenario& scenario, const SwarmSpec& swarm, SwarmModel& model) {
  switch (swarm.model) {
    case Model::kForces:
      model.motor = Motor::kForces;
      model.forces = kernel_forces(scenario, swarm);
      model.far_error = swarm.forces.far_error;
      break;
    case Model::kBoids:
      model.motor = Motor::kBoids;
      model.boids = kernel_boids(swarm.boids);
      break;
    case Model::kBrownian:
      model.motor = Motor::kBrownian;
      model.brownian = kernel_brownian(swarm.brownian);
      break;
    case Model::kField:
    case Model::kOrca:
      model.motor = Motor::kField;
  }
}

kernels::MfAvoidance kernel_avoidance(const SwarmSpec& swarm, float margin, float most_speed) {
  const AvoidanceSpec& spec = swarm.avoidance;
  kernels::MfAvoidance avoidance{};
  avoidance.on = spec.on ? 1 : 0;
  avoidance.radius = std::max(swarm.radius, 0.5F * swarm.limits.separation) + 0.5F * margin;
  avoidance.horizon = spec.horizon;
  avoidance.wall_horizon = spec.wall_horizon;
  avoidance.range = spec.range;
  avoidance.neighbours = std::min(spec.neighbours, MF_MAX_NEIGHBOURS);
  avoidance.most_speed = most_speed;
  avoidance.strict = spec.strict ? 1 : 0;
  return avoidance;
}

}  // namespace mayfly
