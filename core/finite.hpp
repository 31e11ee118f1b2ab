// Whether all of a vector are numbers: NaN passes every comparison, so this is asked before any.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace mayfly {

template <class T>
bool finite(const glm::vec<3, T>& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace mayfly
