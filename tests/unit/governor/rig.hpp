// A governor with columns around it, one swarm, and defaults that a test changes.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "controller/governor/governor.hpp"

namespace mayfly::governor_test {

using namespace std::chrono_literals;

inline GovernorConfig default_config(std::size_t agents) {
  GovernorConfig config;
  config.period = 10ms;
  config.fence = {{-10.0F, -10.0F, -10.0F}, {10.0F, 10.0F, 10.0F}};
  GovernorLimits limits;
  limits.speed = 2.0F;
  limits.acceleration = 4.0F;
  limits.braking = 4.0F;
  limits.radius = 0.1F;
  config.groups = {{0, agents, limits, true}};
  return config;
}

class Rig {
 public:
  explicit Rig(const GovernorConfig& config) : governor(*Governor::make(config)) {
    const std::size_t n = governor.agents();
    for (auto* column : {&x, &y, &z, &vx, &vy, &vz, &wx, &wy, &wz, &ox, &oy, &oz}) {
      column->assign(n, 0.0F);
    }
    known.assign(n, 1);
    authority.assign(n, Authority::kGoverned);
    symptoms.assign(n, Symptoms{});
    kind.assign(n, CommandKind::kNone);
  }

  void place(std::size_t i, glm::vec3 p, glm::vec3 v) {
    x[i] = p.x, y[i] = p.y, z[i] = p.z;
    vx[i] = v.x, vy[i] = v.y, vz[i] = v.z;
  }
  void desire(std::size_t i, glm::vec3 w) { wx[i] = w.x, wy[i] = w.y, wz[i] = w.z; }
  glm::vec3 command(std::size_t i) const { return {ox[i], oy[i], oz[i]}; }
  GovernorState state() const { return {x, y, z, vx, vy, vz, known, authority, measured, anew, kept_clear}; }
  void tick() { governor.govern(now, state(), {wx, wy, wz}, {kind, ox, oy, oz, symptoms}); }
  // Moves an agent to where its command takes it by the next tick.
  void fly(std::size_t i) {
    const GovernorReference at = governor.reference(i);
    const ReferenceModel model{4.0, 0.0};
    Reference robot(0);
    robot.adopt(at.body, at.velocity, model);
    robot.advance(command(i), 0.01, model);
    place(i, glm::vec3(robot.body()), command(i));
  }
  // One tick of agent 0.
  glm::vec3 tick(glm::vec3 desired) {
    now += 10ms;
    desire(0, desired);
    tick();
    return command(0);
  }
  std::uint64_t count(GovernorReason reason) const { return governor.counters().of(reason); }
  std::uint64_t interventions() const { return governor.counters().interventions; }

  Governor governor;
  Time now{0};
  std::vector<float> x, y, z, vx, vy, vz;
  std::vector<float> wx, wy, wz, ox, oy, oz;
  std::vector<std::uint8_t> known, measured, anew;  // the last two may stay empty
  std::vector<Authority> authority;
  std::vector<KeptClear> kept_clear;
  std::vector<Symptoms> symptoms;
  std::vector<CommandKind> kind;
};

}  // namespace mayfly::governor_test
