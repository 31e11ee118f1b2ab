#include "bench/fields/wang14_scalar.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <random>

namespace mayfly::bench {
namespace {

float fade(float t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}
float mix(float t, float a, float b) {
  return a + t * (b - a);
}

// Perlin's reference (2002): a gradient out of the hash's low four bits.
float gradient(int hash, float x, float y, float z) {
  const int h = hash & 15;
  const float u = h < 8 ? x : y;
  const float v = h < 4 ? y : h == 12 || h == 14 ? x : z;
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

float ramp(float r) {  // Eq. 3
  return r >= 1 ? 1 : r <= 0 ? 0 : r * (15.0F / 8 + r * r * (-10.0F / 8 + r * r * 3.0F / 8));
}

}  // namespace

Wang14Scalar::Wang14Scalar(const Grid& grid, std::span<const float> distance, std::span<const float> cost,
                           const Wang14Parameters& parameters)
    : grid_(grid), distance_(distance), cost_(cost), parameters_(parameters), head_(grid.size()) {
  std::mt19937 random(7);
  for (auto& table : permutation_) {
    std::iota(table.begin(), table.begin() + 256, 0);
    std::shuffle(table.begin(), table.begin() + 256, random);
    std::copy_n(table.begin(), 256, table.begin() + 256);
  }
  if (parameters_.tabulated) {
    tabulate();
  }
}

void Wang14Scalar::tabulate() {
  for (int k = 0; k < grid_.cells.z; ++k) {
    for (int j = 0; j < grid_.cells.y; ++j) {
      for (int i = 0; i < grid_.cells.x; ++i) {
        const glm::vec3 n = potential(grid_.center(i, j, k));
        table_[0].push_back(n.x);
        table_[1].push_back(n.y);
        table_[2].push_back(n.z);
      }
    }
  }
}

float Wang14Scalar::sample(std::span<const float> column, glm::vec3 r) const {
  const glm::vec3 u =
      glm::clamp((r - grid_.origin) / grid_.cell - 0.5F, glm::vec3(0.0F), glm::vec3(grid_.cells - 1) - 1e-3F);
  const glm::ivec3 c(u);
  const glm::vec3 t = u - glm::vec3(c);
  float corner[8];
  for (int n = 0; n < 8; ++n) {
    corner[n] = column[grid_.index(c.x + (n & 1), c.y + (n >> 1 & 1), c.z + (n >> 2))];
  }
  const float low = mix(t.y, mix(t.x, corner[0], corner[1]), mix(t.x, corner[2], corner[3]));
  const float high = mix(t.y, mix(t.x, corner[4], corner[5]), mix(t.x, corner[6], corner[7]));
  return mix(t.z, low, high);
}

float Wang14Scalar::noise(int which, glm::vec3 q) const {
  const auto& p = permutation_[static_cast<std::size_t>(which)];
  const glm::vec3 whole = glm::floor(q);
  const int x = static_cast<int>(whole.x) & 255;
  const int y = static_cast<int>(whole.y) & 255;
  const int z = static_cast<int>(whole.z) & 255;
  const glm::vec3 t = q - whole;
  const float u = fade(t.x);
  const float v = fade(t.y);
  const float w = fade(t.z);
  const auto at = [&p](int i) { return p[static_cast<std::size_t>(i)]; };
  const int a = at(x) + y;
  const int b = at(x + 1) + y;
  const int aa = at(a) + z;
  const int ab = at(a + 1) + z;
  const int ba = at(b) + z;
  const int bb = at(b + 1) + z;
  const float front =
      mix(v, mix(u, gradient(at(aa), t.x, t.y, t.z), gradient(at(ba), t.x - 1, t.y, t.z)),
          mix(u, gradient(at(ab), t.x, t.y - 1, t.z), gradient(at(bb), t.x - 1, t.y - 1, t.z)));
  const float back = mix(
      v, mix(u, gradient(at(aa + 1), t.x, t.y, t.z - 1), gradient(at(ba + 1), t.x - 1, t.y, t.z - 1)),
      mix(u, gradient(at(ab + 1), t.x, t.y - 1, t.z - 1), gradient(at(bb + 1), t.x - 1, t.y - 1, t.z - 1)));
  return mix(w, front, back);
}

// N = αP + (1−α)(n·P)n with d0 one cell (Eq. 2, α's trend as the text means it). Beyond d0 it is P.
glm::vec3 Wang14Scalar::potential(glm::vec3 r) const {
  const glm::vec3 q = r / parameters_.scale;
  const glm::vec3 p = parameters_.gain * glm::vec3(noise(0, q), noise(1, q), noise(2, q));
  const float d = sample(distance_, r);
  if (d >= grid_.cell) {
    return p;
  }
  const float h = 0.5F * grid_.cell;
  const glm::vec3 slope(
      sample(distance_, r + glm::vec3(h, 0, 0)) - sample(distance_, r - glm::vec3(h, 0, 0)),
      sample(distance_, r + glm::vec3(0, h, 0)) - sample(distance_, r - glm::vec3(0, h, 0)),
      sample(distance_, r + glm::vec3(0, 0, h)) - sample(distance_, r - glm::vec3(0, 0, h)));
  const float length = glm::length(slope);
  const glm::vec3 n = length > 0 ? slope / length : glm::vec3(0.0F);
  const float alpha = ramp(d / grid_.cell);
  return alpha * p + (1 - alpha) * glm::dot(n, p) * n;
}

glm::vec3 Wang14Scalar::tabulated_potential(glm::vec3 r) const {
  return {sample(table_[0], r), sample(table_[1], r), sample(table_[2], r)};
}

// ∇ × N by central differences, as Bridson et al. (2007), whom the paper follows, do it.
glm::vec3 Wang14Scalar::curl(glm::vec3 r) const {
  const float h = parameters_.tabulated ? 0.5F * grid_.cell : 0.01F * parameters_.scale;
  const auto n = [this](glm::vec3 p) {
    return parameters_.tabulated ? tabulated_potential(p) : potential(p);
  };
  const glm::vec3 dx = n(r + glm::vec3(h, 0, 0)) - n(r - glm::vec3(h, 0, 0));
  const glm::vec3 dy = n(r + glm::vec3(0, h, 0)) - n(r - glm::vec3(0, h, 0));
  const glm::vec3 dz = n(r + glm::vec3(0, 0, h)) - n(r - glm::vec3(0, 0, h));
  return glm::vec3(dy.z - dz.y, dz.x - dx.z, dx.y - dy.x) / (2 * h);
}

// C at r, and `fallback` where a corner of it is blocked.
float Wang14Scalar::cost_near(glm::vec3 r, float fallback) const {
  const float c = sample(cost_, r);
  return std::isfinite(c) ? c : fallback;
}

glm::vec3 Wang14Scalar::downhill(glm::vec3 r) const {
  const float h = 0.5F * grid_.cell;
  const float here = cost_near(r, 0.0F);
  const auto c = [&](float x, float y, float z) { return cost_near(r + glm::vec3(x, y, z), here); };
  const glm::vec3 slope(c(h, 0, 0) - c(-h, 0, 0), c(0, h, 0) - c(0, -h, 0), c(0, 0, h) - c(0, 0, -h));
  const float length = glm::length(slope);
  return length > 0 ? -slope / length : glm::vec3(0.0F);
}

glm::vec3 Wang14Scalar::velocity(glm::vec3 r) const {
  return curl(r) + parameters_.cruise_speed * downhill(r);
}

std::size_t Wang14Scalar::cell_of(glm::vec3 r) const {
  const glm::ivec3 c =
      glm::clamp(glm::ivec3((r - grid_.origin) / grid_.cell), glm::ivec3(0), grid_.cells - 1);
  return grid_.index(c.x, c.y, c.z);
}

// "We iterate all the pairs of agents in the same cell": pairs across a cell's border are not seen.
bool Wang14Scalar::part_pairs() {
  std::fill(head_.begin(), head_.end(), -1);
  next_.resize(at_.size());
  for (std::size_t a = 0; a < at_.size(); ++a) {
    int& head = head_[cell_of(at_[a])];
    next_[a] = head;
    head = static_cast<int>(a);
  }
  bool any = false;
  for (int a = 0; a < static_cast<int>(at_.size()); ++a) {
    for (int b = next_[static_cast<std::size_t>(a)]; b >= 0; b = next_[static_cast<std::size_t>(b)]) {
      glm::vec3& p = at_[static_cast<std::size_t>(a)];
      glm::vec3& q = at_[static_cast<std::size_t>(b)];
      const glm::vec3 line = p - q;
      const float length = glm::length(line);
      if (length >= parameters_.min_distance || length <= 0) {
        continue;
      }
      const glm::vec3 push = line * (0.5F * (parameters_.min_distance - length) / length);
      p += push;
      q -= push;
      moved_[static_cast<std::size_t>(a)] = 1;
      moved_[static_cast<std::size_t>(b)] = 1;
      any = true;
    }
  }
  return any;
}

std::size_t Wang14Scalar::step(float dt) {
  for (glm::vec3& r : at_) {
    r += dt * velocity(r);
  }
  moved_.assign(at_.size(), 0);
  for (int sweep = 0; sweep < parameters_.mde_sweeps && part_pairs(); ++sweep) {
  }
  return static_cast<std::size_t>(std::count(moved_.begin(), moved_.end(), std::uint8_t{1}));
}

}  // namespace mayfly::bench
