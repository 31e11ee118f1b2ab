// Power spectra of regularly sampled signals.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mayfly::bench {

// One-sided power (any unit) at k/(n·period) Hz, k = 0 … n/2, of the mean over windows of n samples, each
// without its mean, tapered by Hann's window, half overlapping (Welch 1967). n must be a power of two. Add
// signals one by one.
class Spectrum {
 public:
  Spectrum(std::size_t window, double period_s);

  // Nothing of a signal that is shorter than a window.
  void add(std::span<const double> signal);

  std::size_t windows() const { return windows_; }
  double frequency(std::size_t k) const {
    return static_cast<double>(k) / (static_cast<double>(window_) * period_s_);
  }
  // Divided by its sum, which is the signal's variance; zeros where nothing was added.
  std::vector<double> shares() const;
  // Mean frequency, Hz, and the share of the power at or above half the highest that there is.
  double centroid() const;
  double upper_half() const;

 private:
  std::size_t window_;
  double period_s_;
  std::vector<double> power_;
  std::size_t windows_ = 0;
};

}  // namespace mayfly::bench
