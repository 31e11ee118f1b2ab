// Curl noise alone: the native lanes on one thread beside a plain scalar implementation.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "bench/fields/measure.hpp"
#include "kernels/noise.h"

namespace mayfly::bench {
namespace {

using kernels::F3;
using kernels::mf3;
using kernels::mf_curl_noise;
using kernels::mf_load;
using kernels::mf_store;
using kernels::MfNoise;

constexpr std::size_t kAgents = 1U << 14U;
constexpr int kRuns = 50;

struct Columns {
  std::vector<float> x = std::vector<float>(kAgents), y = x, z = x;
};

// The same noise as a textbook writes it: one agent, one corner, one component at a time, analytic
// derivatives.
struct Scalar {
  static std::uint32_t hash(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U +
                      static_cast<std::uint32_t>(y) * 0xd8163841U +
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fU + seed;
    h ^= h >> 16U;
    h *= 0x7feb352dU;
    h ^= h >> 15U;
    return h * 0x846ca68bU;
  }
  static void curl(const float p[3], float v[3], std::uint32_t seed) {
    static constexpr float kGradients[16][3] = {
        {1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
        {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {0, -1, 1}, {-1, 1, 0}, {0, -1, -1}};
    int cell[3];
    float t[3], fade[3], slope[3];
    for (int a = 0; a < 3; ++a) {
      cell[a] = static_cast<int>(std::floor(p[a]));
      t[a] = p[a] - static_cast<float>(cell[a]);
      fade[a] = t[a] * t[a] * t[a] * (10 + t[a] * (-15 + t[a] * 6));
      slope[a] = 30 * t[a] * t[a] * (1 + t[a] * (-2 + t[a]));
    }
    float d[3][3] = {};  // d[c][a]: ∂p_c/∂x_a
    for (int corner = 0; corner < 8; ++corner) {
      const int c[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
      const std::uint32_t h = hash(cell[0] + c[0], cell[1] + c[1], cell[2] + c[2], seed);
      float w[3], dw[3], offset[3];
      for (int a = 0; a < 3; ++a) {
        w[a] = c[a] != 0 ? fade[a] : 1 - fade[a];
        dw[a] = c[a] != 0 ? slope[a] : -slope[a];
        offset[a] = t[a] - static_cast<float>(c[a]);
      }
      for (int n = 0; n < 3; ++n) {
        const float* g = kGradients[h >> static_cast<unsigned>(28 - 4 * n) & 15U];
        const float rise = g[0] * offset[0] + g[1] * offset[1] + g[2] * offset[2];
        d[n][0] += w[0] * w[1] * w[2] * g[0] + dw[0] * w[1] * w[2] * rise;
        d[n][1] += w[0] * w[1] * w[2] * g[1] + w[0] * dw[1] * w[2] * rise;
        d[n][2] += w[0] * w[1] * w[2] * g[2] + w[0] * w[1] * dw[2] * rise;
      }
    }
    v[0] = d[2][1] - d[1][2];
    v[1] = d[0][2] - d[2][0];
    v[2] = d[1][0] - d[0][1];
  }
};

template <class Body>
double best_ns_per_agent(Body body) {
  double best = 1e30;
  for (int run = 0; run < kRuns; ++run) {
    const auto start = std::chrono::steady_clock::now();
    body();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    best = std::min(best, took.count() / static_cast<double>(kAgents));
  }
  return best;
}

Columns random_places() {
  Columns at;
  std::mt19937 engine(1);
  std::uniform_real_distribution<float> any(-100, 100);
  for (std::size_t a = 0; a < kAgents; ++a) {
    at.x[a] = any(engine);
    at.y[a] = any(engine);
    at.z[a] = any(engine);
  }
  return at;
}

}  // namespace

Result<void> measure_noise(const FieldsPlan&, Report& report) {
  const Columns at = random_places();
  Columns lanes;
  Columns scalar;
  MfNoise noise{};
  noise.octaves = 1;
  noise.seed = 7;
  noise.inverse_scale[0] = 1;
  noise.gain[0] = 1;
  const double lane_ns = best_ns_per_agent([&] {
    for (std::size_t a = 0; a < kAgents; a += MF_LANES) {
      const F3 at_lanes = mf3(mf_load(&at.x[a]), mf_load(&at.y[a]), mf_load(&at.z[a]));
      const F3 v = mf_curl_noise(at_lanes, &noise, nullptr);
      mf_store(&lanes.x[a], v.x);
      mf_store(&lanes.y[a], v.y);
      mf_store(&lanes.z[a], v.z);
    }
  });
  const double scalar_ns = best_ns_per_agent([&] {
    for (std::size_t a = 0; a < kAgents; ++a) {
      const float p[3] = {at.x[a], at.y[a], at.z[a]};
      float v[3];
      Scalar::curl(p, v, noise.seed);
      scalar.x[a] = v[0];
      scalar.y[a] = v[1];
      scalar.z[a] = v[2];
    }
  });
  float apart = 0;
  for (std::size_t a = 0; a < kAgents; ++a) {
    apart = std::max({apart, std::fabs(lanes.x[a] - scalar.x[a]), std::fabs(lanes.y[a] - scalar.y[a]),
                      std::fabs(lanes.z[a] - scalar.z[a])});
  }
  if (!(apart < 1e-4F)) {
    return fail(Cause::kEnvironment,
                "curl noise and its plain implementation differ by " + std::to_string(apart));
  }
  report.rows.push_back({.key = "curl_noise",
                         .what = "curl noise, an agent, 1 thread",
                         .value = lane_ns,
                         .unit = "ns",
                         .wanted = 30.0,
                         .baseline = "analytic, scalar",
                         .baseline_value = scalar_ns});
  return {};
}

}  // namespace mayfly::bench
