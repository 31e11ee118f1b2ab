#include "controller/metrics/last_seen.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/finite.hpp"

namespace mayfly {
namespace {

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
    if (i < places && finite(at(tick.x, tick.y, tick.z, i))) {
      place_[i] = at(tick.x, tick.y, tick.z, i);
      known_[i] = 1;
    }
    if (i < velocities && finite(at(tick.vx, tick.vy, tick.vz, i))) {
      velocity_[i] = at(tick.vx, tick.vy, tick.vz, i);
    }
  }
}

std::optional<glm::dvec3> centre_of(const LastSeen& seen, AgentRange range) noexcept {
  glm::dvec3 sum(0.0);
  const std::size_t count = for_each_known(seen, range, [&](std::size_t i) { sum += seen.place(i); });
  return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
}

std::optional<double> gyration(const LastSeen& seen, AgentRange range) noexcept {
  const std::optional<glm::dvec3> centre = centre_of(seen, range);
  if (!centre) {
    return std::nullopt;
  }
  double sum = 0.0;
  const std::size_t count = for_each_known(seen, range, [&](std::size_t i) {
    const glm::dvec3 way = seen.place(i) - *centre;
    sum += glm::dot(way, way);
  });
  return std::sqrt(sum / static_cast<double>(count));
}

}  // namespace mayfly
