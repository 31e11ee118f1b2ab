// Agents spread evenly in a cube, each with a velocity of its own, that all want to go the same way.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "controller/engine/engine.hpp"

namespace mayfly::bench {

struct EvenSwarm {
  // So many that about `company` others are within `range` (m) of one away from the sides.
  EvenSwarm(std::size_t agents, float range, float company);

  static constexpr float kPeriod = 0.05F;  // s
  static constexpr float kRange = 1.0F;    // m
  static constexpr int kNeighbours = 10;
  static constexpr float kHorizon = 2.0F;  // s
  static constexpr float kRadius = 0.1F;   // m
  static constexpr float kMostSpeed = 1.5F;

  SwarmModel model(bool strict) const;
  AgentColumns columns() const { return {x, y, z, vx, vy, vz}; }

  float side;  // m
  std::vector<float> x, y, z, vx, vy, vz;
  glm::vec3 wish;  // m/s
  std::vector<float> walls, guide, rest;
};

// The least time a tick took, s.
Result<double> tick_seconds(Engine& engine, const EvenSwarm& swarm, int rounds, bool strict = false);

// Steps of RVO2-3D on the same swarm.
class Rvo2Swarm {
 public:
  // Agents come in the order of the swarm, or along a Morton curve.
  Rvo2Swarm(const EvenSwarm& swarm, int threads, bool morton);
  ~Rvo2Swarm();
  Rvo2Swarm(const Rvo2Swarm&) = delete;
  Rvo2Swarm& operator=(const Rvo2Swarm&) = delete;
  // One step from the swarm's state, s.
  double step_seconds();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mayfly::bench
