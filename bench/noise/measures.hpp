// What is measured of a flight, to say in numbers what Wang14 §7.1 shows in a film.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "bench/noise/track.hpp"

namespace mayfly::bench {

struct Measures {
  // Neighbours within 1 m over those within 4 m, by the volumes of the two balls: how much denser it is
  // around an agent than around its whereabouts. 1 by chance, and > 1 where agents gather. The mean of the
  // second half of the flight, and the largest.
  double clumping = 0.0;
  double clumping_peak = 0.0;
  double density_variation = 0.0;  // deviation over mean, of the neighbours within 2 m; second half
  double near_share = 0.0;         // of the agents nearer than d_min to another; second half
  double tortuosity = 0.0;         // path over displacement, the median agent's
  double turning_rate = 0.0;       // rad/s about the vertical, rms
  double turning_hz = 0.0;         // mean frequency of the turning rate's power
  double turning_high = 0.0;       // share of that power above half the Nyquist frequency
  // How far noise carries an agent in 1 s, over the way that it would go if noise kept its direction; rms.
  double noise_reach = 0.0;
  double stuck_share = 0.0;  // of the agents that came less than 1 m on in the last 5 s
  double progress = 0.0;     // mean displacement over what cruise speed gives
};

// For figures.
struct Curves {
  std::vector<glm::dvec2> clumping;  // over time, s
  std::vector<glm::dvec2> turning;   // share of the turning's power a Hz, over Hz
};

struct Measured {
  Measures measures;
  Curves curves;
};

Measured measure(const Flown& flown, double cruise_speed);

}  // namespace mayfly::bench
