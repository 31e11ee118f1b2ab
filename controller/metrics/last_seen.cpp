#include "controller/metrics/last_seen.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mayfly {
namespace {

bool is_finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 at(std::span<const float> x, std::span<const float> y, std::span<const float> z, std::size_t i) {
  return {x[i], y[i], z[i]};
}

}  // namespace

void LastSeen::update(const MetricsTick& tick) noexcept {
  const std::size_t places = std::min({agents(), tick.x.size(), tick.y.size(), tick.z.size()});
  const std::size_t velocities = std::min({agents(), tick.vx.size(), tick.vy.size(), tick.vz.size()});
  for (std::size_t i = 0; i < agents(); ++i) {
    if (!tick.is_there(i)) {
      known_[i] = 0;
      continue;
    }
    if (i < places && is_finite(at(tick.x, tick.y, tick.z, i))) {
      place_[i] = at(tick.x, tick.y, tick.z, i);
      known_[i] = 1;
    }
    if (i < velocities && is_finite(at(tick.vx, tick.vy, tick.vz, i))) {
      velocity_[i] = at(tick.vx, tick.vy, tick.vz, i);
    }
  }
}

std::optional<double> gyration(const LastSeen& seen, AgentRange range) noexcept {
  glm::dvec3 centre(0.0);
  const std::size_t count = for_each_known(seen, range, [&](std::size_t i) { centre += seen.place(i); });
  if (count == 0) {
    return std::nullopt;
  }
  centre /= static_cast<double>(count);
  double sum = 0.0;
  for_each_known(seen, range, [&](std::size_t i) {
    const glm::dvec3 way = seen.place(i) - centre;
    sum += glm::dot(way, way);
  });
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace mayfly
