// An obstacle that moves along its path, exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "controller/flight/motion.hpp"
#include "controller/governor/moving_obstacle.hpp"
#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"
#include "fields/distance_field.hpp"
#include "fields/geometry.hpp"

namespace mayfly {

struct MovingBody {
  std::size_t obstacle = 0;  // its index in the scenario
  fields::Geometry solid;    // where the scenario gives it
  // Of meshes, whose exact distance is dear: sampled around them, in the same place.
  std::optional<fields::DistanceField> around;
  float start_margin = 0.0F;  // m, by which the first fields make it larger (field_margin.hpp)
};

// All obstacles that have a path, in the scenario's order. Errors are those of Geometry::make and
// build_distance_field.
tl::expected<std::vector<MovingBody>, std::vector<Error>> make_moving_bodies(const Scenario& scenario,
                                                                             int threads);

// What governor and metrics look at; points into `bodies` and `motion`.
std::vector<MovingObstacle> moving_obstacles(std::span<const MovingBody> bodies, const Motion& motion);

}  // namespace mayfly
