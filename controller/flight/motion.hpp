// Where what moves by a script is: goals and obstacles, at the time of a tick.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/scenario/scenario.hpp"

namespace mayfly {

// Whoever looks at a goal or an obstacle in flight keeps a pointer into this, and one set_time() a tick moves
// them all.
class Motion {
 public:
  // `scenario` must outlive it. The time is 0.
  explicit Motion(const Scenario& scenario);

  // s since the flight began. Allocates nothing.
  void set_time(double time_s) noexcept;
  double time_s() const { return time_s_; }

  // m, how far from where the scenario gives it: by the index of a goal, or of an obstacle in the scenario's
  // list. At rest where it has no path.
  const glm::vec3& goal(std::size_t index) const { return goals_[index]; }
  const glm::vec3& obstacle(std::size_t index) const { return obstacles_[index]; }

 private:
  const WorldSpec& world_;
  std::vector<glm::vec3> goals_, obstacles_;
  double time_s_ = 0.0;
};

}  // namespace mayfly
