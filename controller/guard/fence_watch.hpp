// Whether a stopping path leaves the fence: worked out apart from the governor's own account.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/governor/governor_config.hpp"
#include "controller/guard/separation_watch.hpp"

namespace mayfly {

// The convex fence: a box, and half-spaces besides (their normals may have any length but 0); m.
class FenceWatch {
 public:
  FenceWatch(const Box& box, const std::vector<HalfSpace>& half_spaces);

  // Whether a robot would rest beyond the border of any side, radius included. One that is beyond it already
  // may stay as far out, and come back.
  bool is_left_by(const StoppingPath& path) const noexcept;

 private:
  struct Side {
    glm::dvec3 outwards{0.0};  // of length 1
    double distance = 0.0;     // m, of the border from the origin along it
  };
  std::vector<Side> sides_;
};

}  // namespace mayfly
