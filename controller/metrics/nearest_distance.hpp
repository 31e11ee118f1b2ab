// How far agents are from the nearest of their own, exactly.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "controller/metrics/last_seen.hpp"

namespace mayfly {

// A k-d tree that is sorted anew at each call, so that clusters and outliers cost what an even cloud does.
class NearestDistance {
 public:
  // Allocates all that is ever needed for swarms of at most `most` agents.
  explicit NearestDistance(std::size_t most) { points_.reserve(most); }

  // m: the mean over the known agents of the range; empty with fewer than two. Agents at one place are at a
  // distance of 0. O(N log N), double precision; allocates nothing.
  std::optional<double> mean(const LastSeen& seen, AgentRange range) noexcept;

 private:
  void sort(std::size_t first, std::size_t end, int axis) noexcept;
  // m², the least to any other point of [first, end), or `least` where that is less.
  double nearest(std::size_t first, std::size_t end, int axis, std::size_t self, double least) const noexcept;

  std::vector<glm::dvec3> points_;
};

}  // namespace mayfly
