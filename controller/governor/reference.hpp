// Where a robot is by our own account: integrated from the commands as they were sent.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/governor/reservation.hpp"

namespace mayfly {

// What moves it: the robot's part of the limits, in double.
struct ReferenceModel {
  double acceleration = 0.0;  // m/s²; infinite: commands take effect at once
  double response_time = 0.0;
};

// Two points: the lead g, which the commanded velocities move, and the body b, which is the lead, or follows
// it as a lag: db/dt = (g − b)/τ, so that it stays in the hull of where it was and where the lead went.
// Besides, where both were in the last ticks, because a command takes effect up to `latency` ticks late.
class Reference {
 public:
  explicit Reference(int latency);

  bool known() const noexcept { return known_; }
  glm::dvec3 lead() const noexcept { return lead_; }
  glm::dvec3 body() const noexcept { return body_; }
  // m/s: as sent, or on the way to it where the tick was shorter than that takes.
  glm::dvec3 velocity() const noexcept { return velocity_; }

  void forget() noexcept { known_ = false; }
  // As if the robot had been there, at rest, before.
  void adopt(glm::dvec3 place, glm::vec3 velocity, const ReferenceModel& model) noexcept;
  // From one tick to the next, `time` s later, under the command that was sent in the first, m/s.
  void advance(glm::vec3 command, double time, const ReferenceModel& model) noexcept;
  // The velocity that it is told without moving it.
  void set_velocity(glm::vec3 command) noexcept { velocity_ = glm::dvec3(command); }
  // All of it, as it stands, to another place.
  void shift(glm::dvec3 way) noexcept;

  // From the nearest of the places where the body may be to `place`.
  glm::dvec3 way_to(glm::dvec3 place) const noexcept;
  // The corners of where it may be, without the lead of now.
  void add_tail(Hull& hull, const ReferenceModel& model) const noexcept;
  // The farthest of them from the lead, m.
  double tail_reach(const ReferenceModel& model) const noexcept;

 private:
  glm::dvec3 lead_{0.0}, body_{0.0};
  glm::dvec3 velocity_{0.0};
  bool known_ = false;
  std::vector<glm::dvec3> leads_, bodies_;  // of the last ticks, oldest first
};

}  // namespace mayfly
