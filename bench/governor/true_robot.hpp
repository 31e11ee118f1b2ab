// How a robot of the trials really moves: in double, independently of the governor.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace mayfly::bench {

// Its velocity goes straight to the command, at its greatest acceleration. Commands take effect some ticks
// late.
struct TrueRobot {
  glm::dvec3 place{0.0};             // m
  glm::dvec3 velocity{0.0};          // m/s
  double acceleration = 4.0;         // m/s²
  std::deque<glm::dvec3> waiting{};  // commands on the way, one a tick of latency

  // The command that takes effect now, where `newest` was just sent.
  glm::dvec3 exchange(glm::dvec3 newest) {
    waiting.push_back(newest);
    const glm::dvec3 oldest = waiting.front();
    waiting.pop_front();
    return oldest;
  }
  // `time` s later, under one command.
  TrueRobot after(glm::dvec3 command, double time) const {
    const glm::dvec3 change = command - velocity;
    const double needs = glm::length(change) / acceleration;  // s
    TrueRobot later = *this;
    const double ramp = std::min(needs, time);
    const glm::dvec3 along = needs > 0.0 ? change / needs : glm::dvec3(0.0);
    later.velocity = needs > time ? velocity + along * time : command;
    later.place = place + velocity * ramp + 0.5 * ramp * ramp * along + (time - ramp) * later.velocity;
    return later;
  }
};

}  // namespace mayfly::bench
