// Whether a straight line through a nested world keeps away from obstacles. For the nested cost field only.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/nested_grid.hpp"

namespace mayfly::fields {

// Lines of sight at a distance of `room` (m) from obstacles: there a metre costs a metre. Cells without a
// brick are wholly that far away where their centre is outside of obstacles, and no line leaves one for the
// inside of an obstacle without crossing a brick.
class NestedSight {
 public:
  NestedSight(const NestedGrid& nested, std::span<const float> distance, float room)
      : nested_(nested), distance_(distance), room_(room) {}

  // Both ends in m, in the world. Walks along the line by as much as the distance allows; half a fine cell at
  // least, so that it ends. In bricks the nearest sample answers.
  bool clear(glm::vec3 from, glm::vec3 to) const {
    const glm::vec3 way = to - from;
    const float length = glm::length(way);
    const float least = 0.5F * nested_.cell();
    const float slack = 0.8661F * nested_.cell();
    for (float done = 0.0F; done < length;) {
      const glm::vec3 p = from + way * (done / length);
      const glm::ivec3 at = nested_.coarse_cell(p);
      const int brick = nested_.brick_at(at);
      float free = 0.0F;
      if (brick == NestedGrid::kNoBrick) {
        const float phi = distance_[nested_.coarse.index(at.x, at.y, at.z)];
        if (phi < room_) {
          return false;
        }
        free = phi - glm::distance(p, nested_.coarse.center(at.x, at.y, at.z)) - room_;
      } else {
        const glm::vec3 u = (p - nested_.corner(at)) / nested_.cell();
        const glm::ivec3 local =
            glm::clamp(glm::ivec3(u), glm::ivec3(0), glm::ivec3(NestedGrid::kRatio - 1)) + 1;
        const float phi = distance_[nested_.brick_lattice(at).entry(local)];
        if (phi < room_) {
          return false;
        }
        free = phi - slack - room_;
      }
      done += std::max(free, least);
    }
    return true;
  }

 private:
  const NestedGrid& nested_;
  std::span<const float> distance_;
  float room_;
};

}  // namespace mayfly::fields
