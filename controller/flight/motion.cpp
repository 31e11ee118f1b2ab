#include "controller/flight/motion.hpp"

namespace mayfly {
namespace {

template <class Spec>
void displace(const std::vector<Spec>& specs, double time_s, std::vector<glm::vec3>& displacements) noexcept {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    if (specs[i].path) {
      displacements[i] = specs[i].path->displacement(time_s);
    }
  }
}

}  // namespace

Motion::Motion(const Scenario& scenario)
    : world_(scenario.world),
      goals_(world_.goals.size(), glm::vec3(0.0F)),
      obstacles_(world_.obstacles.size(), glm::vec3(0.0F)) {
  set_time(0.0);
}

void Motion::set_time(double time_s) noexcept {
  time_s_ = time_s;
  displace(world_.goals, time_s, goals_);
  displace(world_.obstacles, time_s, obstacles_);
}

}  // namespace mayfly
