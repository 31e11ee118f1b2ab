#include <cmath>
#include <cstddef>

#include "controller/scenario/scenario.hpp"

namespace mayfly {
namespace {

glm::dvec3 leg_of(const PathSpec& path, std::size_t leg) {
  return glm::dvec3(path.points[(leg + 1) % path.points.size()]) - glm::dvec3(path.points[leg]);
}

double length_of(glm::dvec3 v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

// Where on the path: a leg, and the share of it that is behind. Past the end of one that does not loop: the
// leg after the last.
struct Progress {
  std::size_t leg = 0;
  double share = 0.0;
};

Progress progress_at(const PathSpec& path, double time_s) {
  const std::size_t legs = path.points.size() < 2 ? 0 : path.points.size() - (path.loop ? 0 : 1);
  double whole = 0.0;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    whole += length_of(leg_of(path, leg));
  }
  double left = time_s > 0.0 ? time_s * static_cast<double>(path.speed) : 0.0;
  if (path.loop && whole > 0.0) {
    left = std::fmod(left, whole);
  }
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const double length = length_of(leg_of(path, leg));
    if (left < length) {
      return {leg, left / length};
    }
    left -= length;
  }
  return {legs, 0.0};
}

}  // namespace

glm::vec3 PathSpec::displacement(double time_s) const noexcept {
  if (points.empty()) {
    return glm::vec3(0.0F);
  }
  const auto [leg, share] = progress_at(*this, time_s);
  const glm::dvec3 from(points[leg % points.size()]);
  const glm::dvec3 way = share > 0.0 ? share * leg_of(*this, leg) : glm::dvec3(0.0);
  return glm::vec3(from + way - glm::dvec3(points[0]));
}

glm::vec3 PathSpec::velocity(double time_s) const noexcept {
  const auto [leg, share] = progress_at(*this, time_s);
  if (points.size() < 2 || (!loop && leg + 1 >= points.size()) || leg >= points.size()) {
    return glm::vec3(0.0F);
  }
  const glm::dvec3 way = leg_of(*this, leg);
  return glm::vec3(way * (static_cast<double>(speed) / length_of(way)));
}

std::optional<std::size_t> PathSpec::first_point_outside(const Box& shape, const Box& bounds) const {
  constexpr float kRounding = 1e-4F;  // m, of coordinates that are written in decimal
  const Box room{bounds.min - kRounding, bounds.max + kRounding};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 by = points[i] - points[0];
    if (!room.contains(shape.min + by) || !room.contains(shape.max + by)) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace mayfly
