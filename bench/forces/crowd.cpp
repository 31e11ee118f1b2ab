#include "bench/forces/crowd.hpp"

#include <glm/geometric.hpp>
#include <random>
#include <utility>

namespace mayfly::bench {
namespace {

constexpr float kFar = 1000.0F;  // m
constexpr float kMostSpeed = 50.0F;

}  // namespace

std::vector<glm::vec3> strewn_in_box(std::size_t agents, glm::vec3 size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(-0.5F, 0.5F);
  std::vector<glm::vec3> places(agents);
  for (glm::vec3& place : places) {
    place = {size.x * share(random), size.y * share(random), size.z * share(random)};
  }
  return places;
}

std::vector<glm::vec3> strewn_in_ball(std::size_t agents, float radius, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> share(-radius, radius);
  std::vector<glm::vec3> places;
  while (places.size() < agents) {
    const glm::vec3 place(share(random), share(random), share(random));
    if (glm::dot(place, place) <= radius * radius) {
      places.push_back(place);
    }
  }
  return places;
}

Crowd make_crowd(Motor motor, std::vector<glm::vec3> places, float speed) {
  Crowd crowd;
  crowd.velocities = strewn_in_ball(places.size(), speed, 11);
  crowd.places = std::move(places);
  SwarmModel swarm;
  swarm.count = crowd.places.size();
  swarm.motor = motor;
  swarm.field.most_speed = kMostSpeed;
  swarm.field.approach_rate = 25.0F;
  swarm.field.low_x = swarm.field.low_y = swarm.field.low_z = -kFar;
  swarm.field.high_x = swarm.field.high_y = swarm.field.high_z = kFar;
  crowd.swarms.push_back(swarm);
  return crowd;
}

Crowd make_midges(std::size_t agents) {
  constexpr float kRadius = 3.1F;  // m: nobody is farther from another than the outer zone's 6.29 m
  Crowd crowd = make_crowd(Motor::kForces, strewn_in_ball(agents, kRadius), 1.0F);
  kernels::MfForces& forces = crowd.swarms.front().forces;
  forces.friction = 11.16F;
  forces.rep_weight = 5.61F;
  forces.rep_radius = 0.17F;
  forces.ali_weight = 5.0F;
  forces.ali_radius = 1.17F;
  forces.att_weight = 14.29F;
  forces.att_radius = 6.29F;
  return crowd;
}

Crowd make_locusts(std::size_t agents) {
  Crowd crowd = make_crowd(Motor::kForces, strewn_in_box(agents, {24.0F, 5.0F, 0.5F}), 2.0F);
  kernels::MfForces& forces = crowd.swarms.front().forces;
  forces.friction = 13.0F;
  forces.rep_weight = 3.0F;
  forces.rep_radius = 0.45F;
  forces.ali_weight = 5.0F;
  forces.ali_radius = 0.45F;
  forces.att_weight = 5.0F;
  forces.att_radius = 5.45F;
  forces.stimuli = 1;
  forces.stimulus[0] = {.kind = MF_STIMULUS_PREY,
                        .x = 25.0F,
                        .y = 0.0F,
                        .z = 0.0F,
                        .weight = 60.0F,
                        .reach = 25.0F,
                        .distance = 0.0F,
                        .turn = 0.0F};
  return crowd;
}

}  // namespace mayfly::bench
