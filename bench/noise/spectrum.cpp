#include "bench/noise/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace mayfly::bench {
namespace {

using Complex = std::complex<double>;

// In place, for a power of two (Cooley and Tukey 1965).
void transform(std::vector<Complex>& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) {
      j ^= bit;
    }
    j ^= bit;
    if (i < j) {
      std::swap(x[i], x[j]);
    }
  }
  for (std::size_t length = 2; length <= n; length *= 2) {
    for (std::size_t k = 0; k < length / 2; ++k) {
      const double angle = -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length);
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      for (std::size_t first = k; first < n; first += length) {
        const Complex other = x[first + length / 2];  // written out: the library's product looks for NaN
        const Complex odd(c * other.real() - s * other.imag(), c * other.imag() + s * other.real());
        x[first + length / 2] = x[first] - odd;
        x[first] += odd;
      }
    }
  }
}

}  // namespace

Spectrum::Spectrum(std::size_t window, double period_s)
    : window_(window), period_s_(period_s), power_(window / 2 + 1, 0.0) {}

void Spectrum::add(std::span<const double> signal) {
  std::vector<Complex> x(window_);
  for (std::size_t first = 0; first + window_ <= signal.size(); first += window_ / 2) {
    const auto part = signal.subspan(first, window_);
    const double mean = std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(window_);
    for (std::size_t i = 0; i < window_; ++i) {
      const double phase = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(window_);
      x[i] = (part[i] - mean) * 0.5 * (1.0 - std::cos(phase));
    }
    transform(x);
    for (std::size_t k = 0; k < power_.size(); ++k) {
      const bool twice = k > 0 && k < window_ / 2;  // the negative frequency's power is as large
      power_[k] += (twice ? 2.0 : 1.0) * std::norm(x[k]);
    }
    ++windows_;
  }
}

std::vector<double> Spectrum::shares() const {
  std::vector<double> shares = power_;
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) {
    share = sum > 0.0 ? share / sum : 0.0;
  }
  return shares;
}

double Spectrum::centroid() const {
  double mean = 0.0;
  const auto parts = shares();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    mean += parts[k] * frequency(k);
  }
  return mean;
}

double Spectrum::upper_half() const {
  const auto parts = shares();
  return std::accumulate(parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2), parts.end(), 0.0);
}

}  // namespace mayfly::bench
