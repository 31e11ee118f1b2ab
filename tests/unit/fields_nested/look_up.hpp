// A nested world's tables as the kernels read them.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "kernels/field.h"
#include "tests/unit/fields_nested/nested_worlds.hpp"

namespace mayfly::fields::test {

inline kernels::MfGrid kernel_grid(const NestedGrid& nested) {
  const Grid& c = nested.coarse;
  return {c.origin.x, c.origin.y, c.origin.z, nested.cell(), 1.0F / nested.cell(), c.cells.x,
          c.cells.y,  c.cells.z,  1};
}

inline kernels::F3 all_lanes(glm::vec3 p) {
  return kernels::mf3_splat(p.x, p.y, p.z);
}

struct Sampled {
  glm::vec3 direction;  // of length 1, or 0
  float cost;
  bool fine;
};

inline Sampled guide_at(const NestedWorld& world, const CostField& field, glm::vec3 p) {
  const kernels::MfGrid grid = kernel_grid(*world.nested);
  const kernels::MfAround around = kernels::mf_around(all_lanes(p), world.walls.data(), &grid);
  kernels::F g[4];
  kernels::mf_around_sample4(field.guide.data(), &around, &grid, g);
  const glm::vec3 way(g[0][0], g[1][0], g[2][0]);
  const float length = glm::length(way);
  return {length > 0.0F ? way / length : way, g[3][0], around.place.fine[0] != 0};
}

}  // namespace mayfly::fields::test
