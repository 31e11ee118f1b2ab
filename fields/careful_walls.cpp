#include "fields/careful_walls.hpp"

#include <algorithm>
#include <vector>

#include "fields/parallel.hpp"
#include "kernels/grid.h"

namespace mayfly::fields {
namespace {

// In cell sides. Cells whose centre lies deeper hold no place that an agent may be at; farther out the spline
// is not asked for more than "not near".
constexpr float kDeepest = -0.9F;
constexpr float kFarthest = 1.2F;

// By how much the spline tells too much at the middles of the eight octants of a cell, at most; m.
float excess_in(const Geometry& solid, const kernels::MfGrid& grid, glm::vec3 center,
                std::span<const float> coefficients) {
  const float quarter = 0.25F * grid.cell;
  kernels::F3 at{};
  for (int k = 0; k < MF_LANES; ++k) {
    at.x[k] = center.x + ((k & 1) != 0 ? quarter : -quarter);
    at.y[k] = center.y + ((k & 2) != 0 ? quarter : -quarter);
    at.z[k] = center.z + ((k & 4) != 0 ? quarter : -quarter);
  }
  const kernels::MfSurface told = kernels::mf_surface(at, coefficients.data(), &grid);
  float excess = 0.0F;
  for (int k = 0; k < MF_LANES; ++k) {
    excess = std::max(excess, told.value[k] - solid.signed_distance({at.x[k], at.y[k], at.z[k]}));
  }
  return excess;
}

// The largest of `values` among a cell and its neighbours along one axis, in place, line by line.
void widen(const Grid& grid, int axis, std::vector<float>& values) {
  const glm::ivec3 n = grid.cells;
  const std::size_t step = axis == 0 ? 1 : axis == 1 ? grid.index(0, 1, 0) : grid.index(0, 0, 1);
  glm::ivec3 lines = n;
  lines[axis] = 1;
  for (int k = 0; k < lines.z; ++k) {
    for (int j = 0; j < lines.y; ++j) {
      for (int i = 0; i < lines.x; ++i) {
        float before = 0.0F;
        std::size_t cell = grid.index(i, j, k);
        for (int along = 0; along < n[axis]; ++along, cell += step) {
          const float here = values[cell];
          const float after = along + 1 < n[axis] ? values[cell + step] : 0.0F;
          values[cell] = std::max({before, here, after});
          before = here;
        }
      }
    }
  }
}

}  // namespace

void lower_walls(const Geometry& solid, const DistanceField& distance, int threads,
                 std::span<float> coefficients) {
  const Grid& grid = distance.grid;
  const kernels::MfGrid lookup{grid.origin.x, grid.origin.y, grid.origin.z, grid.cell, 1.0F / grid.cell,
                               grid.cells.x,  grid.cells.y,  grid.cells.z,  0};
  std::vector<float> excess(grid.size(), 0.0F);
  const auto plane = [&](std::size_t k) {
    for (int j = 0; j < grid.cells.y; ++j) {
      for (int i = 0; i < grid.cells.x; ++i) {
        const std::size_t cell = grid.index(i, j, static_cast<int>(k));
        const float cells_off = distance.distance[cell] / grid.cell;
        if (cells_off > kDeepest && cells_off < kFarthest) {
          excess[cell] = excess_in(solid, lookup, grid.center(i, j, static_cast<int>(k)), coefficients);
        }
      }
    }
  };
  parallel_for(static_cast<std::size_t>(grid.cells.z), threads, "walls", {}, plane);
  // In any cell the spline is a mean of the 27 coefficients around: each must give way for all that it
  // reaches.
  for (int axis = 0; axis < 3; ++axis) {
    widen(grid, axis, excess);
  }
  for (std::size_t cell = 0; cell < excess.size(); ++cell) {
    coefficients[cell] -= excess[cell];
  }
}

}  // namespace mayfly::fields
