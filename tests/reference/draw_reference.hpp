// Random draws, pulls and the other noises in double precision, written from kernels/draw.h's documentation
// and model.md §1 and §4.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "tests/reference/walls_reference.hpp"

namespace mayfly::reference {

inline std::uint32_t mixed(std::uint32_t h) {
  h = (h ^ (h >> 16U)) * 0x7feb352dU;
  return (h ^ (h >> 15U)) * 0x846ca68bU;
}

// The word that agent `id` draws from `stream` in a tick with these keys.
inline std::uint32_t drawn(std::uint32_t key_a, std::uint32_t key_b, std::uint32_t id, std::uint32_t stream) {
  const std::uint32_t h = mixed(id * 0x9e3779b9U + key_a);
  return mixed((h ^ (h >> 16U)) + key_b + stream * 0x85ebca6bU);
}

inline double unit_interval(std::uint32_t word) {
  return std::ldexp(word >> 8U, -24);
}
inline double symmetric_interval(std::uint32_t word) {
  return 2 * unit_interval(word) - 1 + std::ldexp(1.0, -24);
}
inline double normal(std::uint32_t first, std::uint32_t second) {
  const double w1 = unit_interval(first) + std::ldexp(1.0, -24);
  return std::sqrt(-2 * std::log(w1)) * std::sin(2 * std::numbers::pi * unit_interval(second));
}

// The velocity along the gradient of the potential speed · reach/s · h(|x − center|/reach), s the bell's
// steepest slope.
inline Vec brush_velocity(Vec x, Vec center, double reach, double speed) {
  double steepest = 0;
  for (int n = 0; n < 100'000; ++n) {
    steepest = std::max(steepest, (bell(n * 1e-5) - bell((n + 1) * 1e-5)) * 1e5);
  }
  const auto potential = [&](Vec p) { return speed * reach / steepest * bell(norm(p - center) / reach); };
  Vec v{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec step{};
    step[axis] = 1e-4;
    v[axis] = (potential(x + step) - potential(x - step)) / 2e-4;
  }
  return v;
}

}  // namespace mayfly::reference
