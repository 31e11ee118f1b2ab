#include "controller/metrics/nearest_distance.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mayfly {

std::optional<double> NearestDistance::mean(const LastSeen& seen, AgentRange range) noexcept {
  points_.clear();
  for_each_known(seen, range, [&](std::size_t i) {
    if (points_.size() < points_.capacity()) {
      points_.push_back(seen.place(i));
    }
  });
  if (points_.size() < 2) {
    return std::nullopt;
  }
  sort(0, points_.size(), 0);
  double sum = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    sum += std::sqrt(nearest(0, points_.size(), 0, i, std::numeric_limits<double>::infinity()));
  }
  return sum / static_cast<double>(points_.size());
}

// The middle of a range divides it along an axis that changes from level to level.
void NearestDistance::sort(std::size_t first, std::size_t end, int axis) noexcept {
  while (end - first > 1) {
    const std::size_t middle = first + (end - first) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(end),
                     [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
    axis = (axis + 1) % 3;
    sort(first, middle, axis);
    first = middle + 1;
  }
}

double NearestDistance::nearest(std::size_t first, std::size_t end, int axis, std::size_t self,
                                double least) const noexcept {
  while (first < end) {
    const std::size_t middle = first + (end - first) / 2;
    const glm::dvec3 way = points_[middle] - points_[self];
    if (middle != self) {
      least = std::min(least, glm::dot(way, way));
    }
    const double beyond = way[axis];
    axis = (axis + 1) % 3;
    const bool below = beyond > 0.0 || (beyond == 0.0 && self < middle);
    least = below ? nearest(first, middle, axis, self, least) : nearest(middle + 1, end, axis, self, least);
    if (beyond * beyond >= least) {
      return least;
    }
    first = below ? middle + 1 : first;
    end = below ? end : middle;
  }
  return least;
}

}  // namespace mayfly
