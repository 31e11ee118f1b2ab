// The plants in double precision, written from their differential equations.
#pragma once

#include <algorithm>
#include <cmath>

namespace mayfly::reference {

struct Motion1 {
  double p;  // m
  double v;  // m/s
};

// τ dv/dt = u − v, dp/dt = v, solved at time t from v(0), p(0).
inline Motion1 velocity_lag(Motion1 start, double u, double tau, double t) {
  const double decay = std::exp(-t / tau);
  return {start.p + u * t + (start.v - u) * tau * (1.0 - decay), u + (start.v - u) * decay};
}

// dv/dt = ±a until v = u, then 0; dp/dt = v.
inline Motion1 double_integrator(Motion1 start, double u, double a, double t) {
  const double until = std::abs(u - start.v) / a;
  const double pushing = std::min(t, until);
  const double direction = u > start.v ? 1.0 : -1.0;
  const double v = t < until ? start.v + direction * a * t : u;
  const double p = start.p + start.v * pushing + 0.5 * direction * a * pushing * pushing + v * (t - pushing);
  return {p, v};
}

}  // namespace mayfly::reference
