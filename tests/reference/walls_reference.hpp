// Ramp, bell, the quadratic B-spline of a table and the potential beside walls, in double precision, from
// model.md §1–2.
#pragma once

#include <cmath>
#include <vector>

#include "core/grid.hpp"
#include "tests/reference/noise_reference.hpp"

namespace mayfly::reference {

inline double ramp(double r) {
  if (r <= 0) {
    return 0;
  }
  return r >= 1 ? 1 : 15.0 / 8 * r - 10.0 / 8 * std::pow(r, 3) + 3.0 / 8 * std::pow(r, 5);
}

inline double bell(double r) {
  if (r < 0) {
    return 1;
  }
  return r > 1 ? 0 : 1 - 4.0 / 9 * std::pow(r, 6) + 17.0 / 9 * std::pow(r, 4) - 22.0 / 9 * std::pow(r, 2);
}

// The centred quadratic B-spline.
inline double b2(double t) {
  t = std::fabs(t);
  if (t <= 0.5) {
    return 0.75 - t * t;
  }
  return t <= 1.5 ? 0.5 * (1.5 - t) * (1.5 - t) : 0;
}

// Σ table · b2, for points at least two cells inside the grid.
inline double spline(const std::vector<float>& table, const Grid& grid, Vec x) {
  const Vec u{(x[0] - grid.origin.x) / grid.cell - 0.5, (x[1] - grid.origin.y) / grid.cell - 0.5,
              (x[2] - grid.origin.z) / grid.cell - 0.5};
  double sum = 0;
  for (int k = static_cast<int>(u[2]) - 1; k <= static_cast<int>(u[2]) + 2; ++k) {
    for (int j = static_cast<int>(u[1]) - 1; j <= static_cast<int>(u[1]) + 2; ++j) {
      for (int i = static_cast<int>(u[0]) - 1; i <= static_cast<int>(u[0]) + 2; ++i) {
        sum += static_cast<double>(table[grid.index(i, j, k)]) * b2(u[0] - i) * b2(u[1] - j) * b2(u[2] - k);
      }
    }
  }
  return sum;
}

// N = αP + (1−α)(n·P)n, n = ∇φ/|∇φ|, α = ramp(φ/d0).
template <class Phi, class Potential>
Vec bounded_potential(const Phi& phi, const Potential& potential, Vec x, double d0) {
  Vec gradient{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec step{};
    step[axis] = 1e-4;
    gradient[axis] = (phi(x - step * 2) - phi(x + step * 2) + 8 * (phi(x + step) - phi(x - step))) / 12e-4;
  }
  const Vec n = gradient * (1 / norm(gradient));
  const double alpha = ramp(phi(x) / d0);
  const Vec p = potential(x);
  return p * alpha + n * ((1 - alpha) * dot(n, p));
}

}  // namespace mayfly::reference
