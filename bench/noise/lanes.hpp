// From vectors to lanes and back.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <span>

#include "kernels/lane.h"

namespace mayfly::bench {

// The agents from `first` on; lanes beyond the last repeat it.
inline kernels::F3 lanes_of(std::span<const glm::vec3> vectors, std::size_t first) {
  kernels::F3 lanes{};
  for (std::size_t k = 0; k < MF_LANES; ++k) {
    const glm::vec3 v = vectors[std::min(first + k, vectors.size() - 1)];
    lanes.x[k] = v.x;
    lanes.y[k] = v.y;
    lanes.z[k] = v.z;
  }
  return lanes;
}

inline void store_lanes(const kernels::F3& lanes, std::span<glm::vec3> vectors, std::size_t first) {
  for (std::size_t k = 0; k < MF_LANES && first + k < vectors.size(); ++k) {
    vectors[first + k] = {lanes.x[k], lanes.y[k], lanes.z[k]};
  }
}

}  // namespace mayfly::bench
