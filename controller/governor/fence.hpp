// The convex fence: a box, and half-spaces besides.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "controller/governor/governor_config.hpp"
#include "controller/governor/reservation.hpp"

namespace mayfly {

class Fence {
 public:
  Fence(const Box& box, const std::vector<HalfSpace>& half_spaces);

  // Whether a hull keeps `kept` from the border: a convex fence contains it if it contains its corners. Where
  // braking alone goes farther out, that far is allowed: who is outside may come back.
  bool holds(const Hull& wanted, const Hull& braking, double kept) const noexcept;
  // m: how far a place is from the border; negative outside.
  double depth(glm::dvec3 place) const noexcept;
  // m: the greatest depth that is found from `place` on, a little less than there is.
  double room_from(glm::dvec3 place) const noexcept;

 private:
  struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
  };
  std::vector<Plane> planes_;
};

}  // namespace mayfly
