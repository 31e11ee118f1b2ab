#include "fields/spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace mayfly::fields {
namespace {

// The inverse of the filter (1/8, 6/8, 1/8) that sampling a quadratic B-spline is: one pole, run forth and
// back.
const double kPole = 2.0 * std::sqrt(2.0) - 3.0;
constexpr double kGain = 8.0;
// |pole|^18 is below float's precision: so many samples are enough to start the recursion.
constexpr std::ptrdiff_t kHorizon = 18;

// Filters n values `stride` apart in place.
void filter_line(float* line, std::ptrdiff_t n, std::ptrdiff_t stride, std::vector<double>& c) {
  if (n < 2) {
    return;
  }
  const auto mirrored = [&](std::ptrdiff_t i) {
    const std::ptrdiff_t period = 2 * n - 2;
    i %= period;
    return static_cast<double>(line[(i < n ? i : period - i) * stride]);
  };
  double start = 0.0;
  double power = 1.0;
  for (std::ptrdiff_t i = 0; i < kHorizon; ++i) {
    start += power * mirrored(i);
    power *= kPole;
  }
  const auto last = static_cast<std::size_t>(n - 1);
  c[0] = start;
  for (std::size_t i = 1; i <= last; ++i) {
    c[i] = static_cast<double>(line[static_cast<std::ptrdiff_t>(i) * stride]) + kPole * c[i - 1];
  }
  c[last] = kPole / (kPole * kPole - 1.0) * (c[last] + kPole * c[last - 1]);
  for (std::size_t i = last; i-- > 0;) {
    c[i] = kPole * (c[i + 1] - c[i]);
  }
  for (std::size_t i = 0; i <= last; ++i) {
    line[static_cast<std::ptrdiff_t>(i) * stride] = static_cast<float>(kGain * c[i]);
  }
}

}  // namespace

std::vector<float> spline_coefficients(const Grid& grid, std::span<const float> values) {
  std::vector<float> c(values.begin(), values.end());
  const std::ptrdiff_t nx = grid.cells.x;
  const std::ptrdiff_t ny = grid.cells.y;
  const std::ptrdiff_t nz = grid.cells.z;
  std::vector<double> line(static_cast<std::size_t>(std::max({nx, ny, nz, std::ptrdiff_t{1}})));
  for (std::ptrdiff_t row = 0; row < ny * nz; ++row) {
    filter_line(c.data() + row * nx, nx, 1, line);
  }
  for (std::ptrdiff_t k = 0; k < nz; ++k) {
    for (std::ptrdiff_t i = 0; i < nx; ++i) {
      filter_line(c.data() + k * nx * ny + i, ny, nx, line);
    }
  }
  for (std::ptrdiff_t i = 0; i < nx * ny; ++i) {
    filter_line(c.data() + i, nz, nx * ny, line);
  }
  return c;
}

}  // namespace mayfly::fields
