// Helpers that put one point into all lanes of a kernel and take one lane out.
#pragma once

#include <random>
#include <vector>

#include "kernels/field.h"
#include "tests/reference/noise_reference.hpp"

namespace mayfly::test {

inline kernels::F3 all_lanes(reference::Vec v) {
  return kernels::mf3_splat(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]));
}

inline reference::Vec lane(kernels::F3 v, int k = 0) {
  return {v.x[k], v.y[k], v.z[k]};
}

inline kernels::MfNoise noise_of(std::uint32_t seed, float scale, float gain, bool permuted = false) {
  kernels::MfNoise noise{};
  noise.octaves = 1;
  noise.permuted = permuted ? 1 : 0;
  noise.seed = seed;
  noise.inverse_scale[0] = 1.0F / scale;
  noise.gain[0] = gain;
  return noise;
}

// Random points on multiples of 2^-12 m: exact in float, so that a reference in double sees the same point.
class Points {
 public:
  explicit Points(double half_width, unsigned seed = 1) : half_width_(half_width), engine_(seed) {}
  reference::Vec next() { return {coordinate(), coordinate(), coordinate()}; }

 private:
  double coordinate() {
    return std::round(std::uniform_real_distribution<double>(-half_width_, half_width_)(engine_) * 4096) /
           4096;
  }
  double half_width_;
  std::mt19937 engine_;
};

}  // namespace mayfly::test
