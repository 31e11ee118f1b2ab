#include "fields/spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fields/double8.hpp"
#include "fields/parallel.hpp"

namespace mayfly::fields {
namespace {

// The inverse of the filter (1/8, 6/8, 1/8) that sampling a quadratic B-spline is: one pole, run forth and
// back.
const double kPole = 2.0 * std::sqrt(2.0) - 3.0;
constexpr double kGain = 8.0;
// |pole|^18 is below float's precision: so many samples are enough to start the recursion.
constexpr std::size_t kHorizon = 18;
// Lines are filtered eight at a time: a recursion of one waits for each product of its own.
constexpr std::ptrdiff_t kLines = 8;

// Filters eight lines in place.
void filter(std::span<Double8> line) {
  const std::size_t n = line.size();
  const std::size_t period = 2 * n - 2;
  Double8 start = splat<Double8>(0.0);
  double power = 1.0;
  for (std::size_t i = 0; i < kHorizon; ++i) {
    const std::size_t at = i % period;
    start = start + line[at < n ? at : period - at] * power;
    power *= kPole;
  }
  line[0] = start;
  for (std::size_t i = 1; i < n; ++i) {
    line[i] = line[i] + line[i - 1] * kPole;
  }
  line[n - 1] = (line[n - 1] + line[n - 2] * kPole) * (kPole / (kPole * kPole - 1.0));
  for (std::size_t i = n - 1; i-- > 0;) {
    line[i] = (line[i + 1] - line[i]) * kPole;
  }
}

// Filters up to eight lines of n values that are `step` apart; the lines begin `apart` from each other.
void filter_lines(float* first, std::ptrdiff_t lines, std::ptrdiff_t apart, std::ptrdiff_t n,
                  std::ptrdiff_t step, std::vector<Double8>& buffer) {
  if (n < 2) {
    return;
  }
  buffer.resize(static_cast<std::size_t>(n));
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    Double8 all = splat<Double8>(0.0);
    for (std::ptrdiff_t l = 0; l < lines; ++l) {
      all.set(static_cast<int>(l), static_cast<double>(first[i * step + l * apart]));
    }
    buffer[static_cast<std::size_t>(i)] = all;
  }
  filter(buffer);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Double8 all = buffer[static_cast<std::size_t>(i)] * kGain;
    for (std::ptrdiff_t l = 0; l < lines; ++l) {
      first[i * step + l * apart] = static_cast<float>(all[static_cast<int>(l)]);
    }
  }
}

// Filters `count` lines, eight by eight.
void filter_all(float* first, std::ptrdiff_t count, std::ptrdiff_t apart, std::ptrdiff_t n,
                std::ptrdiff_t step, std::vector<Double8>& buffer) {
  for (std::ptrdiff_t line = 0; line < count; line += kLines) {
    filter_lines(first + line * apart, std::min(kLines, count - line), apart, n, step, buffer);
  }
}

}  // namespace

void fill_spline_coefficients(const Grid& grid, std::span<const float> values, int threads,
                              std::span<float> coefficients) {
  const std::ptrdiff_t nx = grid.cells.x;
  const std::ptrdiff_t ny = grid.cells.y;
  const std::ptrdiff_t nz = grid.cells.z;
  const std::ptrdiff_t plane = nx * ny;
  parallel_for(static_cast<std::size_t>(nz), threads, {}, {}, [&](std::size_t k) {
    float* const c = coefficients.data() + static_cast<std::ptrdiff_t>(k) * plane;
    std::copy_n(values.data() + static_cast<std::ptrdiff_t>(k) * plane, plane, c);
    std::vector<Double8> buffer;
    filter_all(c, ny, nx, nx, 1, buffer);
    filter_all(c, nx, 1, ny, nx, buffer);
  });
  parallel_for(static_cast<std::size_t>(ny), threads, {}, {}, [&](std::size_t j) {
    std::vector<Double8> buffer;
    filter_all(coefficients.data() + static_cast<std::ptrdiff_t>(j) * nx, nx, 1, nz, plane, buffer);
  });
}

std::vector<float> spline_coefficients(const Grid& grid, std::span<const float> values) {
  std::vector<float> coefficients(values.size());
  fill_spline_coefficients(grid, values, 1, coefficients);
  return coefficients;
}

}  // namespace mayfly::fields
