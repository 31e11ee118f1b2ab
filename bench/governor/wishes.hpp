// What the robots of a trial are told by somebody who means no good, or by collision avoidance.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <random>
#include <vector>

#include "bench/governor/trial.hpp"
#include "controller/engine/engine.hpp"

namespace mayfly::bench {

struct Columns {
  explicit Columns(std::size_t n) : x(n), y(n), z(n) {}
  void set(std::size_t i, glm::vec3 v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
  glm::vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  std::vector<float> x, y, z;
};

class Wisher {
 public:
  // `arena`: m, its far corner; the near one is the origin.
  Wisher(const TrialPlan& plan, glm::vec3 arena, float most_speed);

  Result<void> prepare();
  // m/s for every robot, from where all are and what they were told last.
  const Columns& wish(std::uint64_t tick, const Columns& places, const Columns& velocities);
  std::uint64_t goals_reached() const { return reached_; }

 private:
  void wish_hostile(std::uint64_t tick, const Columns& places);
  glm::vec3 hostile(std::uint64_t tick, std::size_t agent, const Columns& places);
  glm::vec3 to_nearest(std::size_t agent, const Columns& places) const;
  void renew_goals(const Columns& places);
  SwarmModel model() const;
  glm::vec3 somewhere();
  glm::vec3 jerk();

  TrialPlan plan_;
  glm::vec3 arena_;
  float most_speed_;
  std::mt19937_64 random_;
  Columns goals_;
  Columns wishes_;
  glm::vec3 point_{0.0F};  // where all are sent to
  std::vector<float> walls_{0.0F};
  std::vector<float> guide_{1.0F, 0.0F, 0.0F, -1.0F};  // everybody is in the goal, and flies to a place in it
  std::unique_ptr<Engine> engine_;
  std::uint64_t reached_ = 0;
};

}  // namespace mayfly::bench
