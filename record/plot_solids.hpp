// A world's obstacles as plain triangles, for drawing.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "core/result.hpp"

namespace mayfly::record {

using Triangle = std::array<glm::vec3, 3>;  // m, world frame

// Round shapes in facets, half-spaces cut off at the bounds. Reads mesh files again: errors are theirs.
Result<std::vector<Triangle>> triangles_of(std::span<const ObstacleSpec> obstacles, const Box& bounds);

}  // namespace mayfly::record
