#include "controller/guard/separation_watch.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace mayfly {
namespace {

// m: what rounding of positions to float can shift in a world of a kilometre.
constexpr double kRounding = 2e-4;

double clamp01(double value) noexcept {
  return std::clamp(value, 0.0, 1.0);
}

}  // namespace

double segment_distance(const glm::dvec3& a0, const glm::dvec3& a1, const glm::dvec3& b0,
                        const glm::dvec3& b1) noexcept {
  const glm::dvec3 u = a1 - a0;
  const glm::dvec3 v = b1 - b0;
  const glm::dvec3 w = a0 - b0;
  const double uu = glm::dot(u, u);
  const double uv = glm::dot(u, v);
  const double vv = glm::dot(v, v);
  const double uw = glm::dot(u, w);
  const double vw = glm::dot(v, w);
  const double parallel = uu * vv - uv * uv;
  double s = parallel > 1e-12 * uu * vv ? clamp01((uv * vw - vv * uw) / parallel) : 0.0;
  const double t = vv > 0.0 ? clamp01((uv * s + vw) / vv) : 0.0;
  s = uu > 0.0 ? clamp01((uv * t - uw) / uu) : 0.0;
  return glm::length(w + s * u - t * v);
}

SeparationWatch::SeparationWatch(std::size_t robots) : order_(robots), low_(robots), high_(robots) {
  std::iota(order_.begin(), order_.end(), 0U);
}

bool SeparationWatch::touches(const StoppingPath& a, const StoppingPath& b) noexcept {
  const double kept = a.radius + b.radius - kRounding;
  const glm::dvec3 flat(1.0, 1.0, 1.0 / std::min(a.downwash, b.downwash));
  const glm::dvec3 a0 = a.from * flat;
  const glm::dvec3 a1 = a.to * flat;
  const glm::dvec3 b0 = b.from * flat;
  const glm::dvec3 b1 = b.to * flat;
  // Mostly one of the other axes tells them apart.
  for (int axis = 1; axis < 3; ++axis) {
    if (std::max(a0[axis], a1[axis]) + kept < std::min(b0[axis], b1[axis]) ||
        std::max(b0[axis], b1[axis]) + kept < std::min(a0[axis], a1[axis])) {
      return false;
    }
  }
  return segment_distance(a0, a1, b0, b1) < kept;
}

// Those that do not count stand at the end, beyond everybody's reach.
void SeparationWatch::sort(std::span<const StoppingPath> paths) noexcept {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const StoppingPath& path = paths[i];
    low_[i] = path.counts ? std::min(path.from.x, path.to.x) - path.radius : kNowhere;
    high_[i] = path.counts ? std::max(path.from.x, path.to.x) + path.radius : -kNowhere;
  }
  for (std::size_t k = 1; k < order_.size(); ++k) {
    const std::uint32_t moved = order_[k];
    std::size_t at = k;
    for (; at > 0 && low_[order_[at - 1]] > low_[moved]; --at) {
      order_[at] = order_[at - 1];
    }
    order_[at] = moved;
  }
}

}  // namespace mayfly
