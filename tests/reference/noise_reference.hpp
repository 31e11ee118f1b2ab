// Gradient noise, its potential and its curl in double precision, written from model.md §1 and Perlin (2002).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

namespace mayfly::reference {

struct Vec : std::array<double, 3> {};  // a type of this namespace, so that its operators are found

inline Vec operator+(Vec a, Vec b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec operator-(Vec a, Vec b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec operator*(Vec a, double s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
inline double dot(Vec a, Vec b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(Vec a) {
  return std::sqrt(dot(a, a));
}

// The gradient slot (0…15) of a lattice point for one of the three noises.
using Slots = std::function<unsigned(std::int64_t x, std::int64_t y, std::int64_t z, int noise)>;

// As the integer hash is documented: premultiplied coordinates, Wellons' lowbias32 without its last shift,
// the top bits.
inline Slots hashed_slots(std::uint32_t seed) {
  return [seed](std::int64_t x, std::int64_t y, std::int64_t z, int noise) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U + seed +
                      static_cast<std::uint32_t>(y) * 0xd8163841U +
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
    h ^= h >> 16U;
    h *= 0x7feb352dU;
    h ^= h >> 15U;
    h *= 0x846ca68bU;
    return h >> static_cast<unsigned>(28 - 4 * noise) & 15U;
  };
}

// Perlin's reference: hash of the cell's corner, and his way of reading a gradient out of its low bits.
inline double gradient_dot(unsigned slot, Vec d) {
  const double u = slot < 8 ? d[0] : d[1];
  const double v = slot < 4 ? d[1] : (slot == 12 || slot == 14 ? d[0] : d[2]);
  return ((slot & 1U) == 0 ? u : -u) + ((slot & 2U) == 0 ? v : -v);
}

inline double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

inline double noise(Vec q, const Slots& slots, int which) {
  const Vec cell{std::floor(q[0]), std::floor(q[1]), std::floor(q[2])};
  const Vec t = q - cell;
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const std::array<int, 3> c{corner & 1, corner >> 1 & 1, corner >> 2};
    double weight = 1;
    Vec d{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      weight *= c[axis] != 0 ? fade(t[axis]) : 1 - fade(t[axis]);
      d[axis] = t[axis] - c[axis];
    }
    const auto at = [&](std::size_t axis) { return static_cast<std::int64_t>(cell[axis]) + c[axis]; };
    sum += weight * gradient_dot(slots(at(0), at(1), at(2), which), d);
  }
  return sum;
}

inline Vec potential(Vec x, double scale, double gain, const Slots& slots) {
  const Vec q = x * (1 / scale);
  return Vec{noise(q, slots, 0), noise(q, slots, 1), noise(q, slots, 2)} * gain;
}

// ∂f/∂axis by a five-point difference: with h small against the features of f the error is far below float
// precision.
template <class Function>
Vec derivative(const Function& f, Vec x, std::size_t axis, double h = 1e-3) {
  Vec step{};
  step[axis] = h;
  return (f(x - step * 2) - f(x + step * 2) + (f(x + step) - f(x - step)) * 8) * (1 / (12 * h));
}

template <class Function>
Vec curl(const Function& f, Vec x, double h = 1e-3) {
  const Vec dx = derivative(f, x, 0, h);
  const Vec dy = derivative(f, x, 1, h);
  const Vec dz = derivative(f, x, 2, h);
  return {dy[2] - dz[1], dz[0] - dx[2], dx[1] - dy[0]};
}

// Divergence of f, and the Frobenius norm of its gradient to measure it by.
template <class Function>
std::array<double, 2> divergence_and_gradient(const Function& f, Vec x, double h) {
  double square = 0;
  double trace = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec d = derivative(f, x, axis, h);
    square += dot(d, d);
    trace += d[axis];
  }
  return {trace, std::sqrt(square)};
}

}  // namespace mayfly::reference
