// A look at a sampled distance field, and what it proves about the points between its samples.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

#include "core/grid.hpp"
#include "core/nested_grid.hpp"

namespace mayfly {

// φ in m at cell centres, as fields::DistanceField holds it; `data` outlives the view, null where there are
// no obstacles.
//
// Trilinear interpolation of a 1-Lipschitz function is a mean of the 8 corner values with weights w, each off
// by at most the distance to its corner: |interpolated − φ(x)| ≤ Σ w·|corner − x| ≤ √Σ w·|corner − x|² =
// cell·√Σ t(1 − t) over the three axes, t being the fraction of the cell (the second step is Jensen's).
// Nothing at a corner, √¾ of a cell at worst.
struct DistanceView {
  const float* data = nullptr;
  Grid grid;
  const NestedGrid* nested = nullptr;  // given: what `data` lies on; `grid` is not looked at

  struct Sample {
    double value = 0.0;  // m, interpolated
    double error = 0.0;  // m, the most by which the exact φ differs from it
  };

  bool empty() const { return data == nullptr; }

  // x, y, z in m, finite. Outside the centres' box the nearest point of it answers; the way to it adds to the
  // error.
  Sample sample(double x, double y, double z) const noexcept {
    if (nested == nullptr) {
      return sample_on(grid, data, x, y, z);
    }
    const Lattice cells = nested->lattice_at(glm::vec3(x, y, z));
    return sample_on(cells.grid, data + cells.first, x, y, z);
  }

 private:
  static Sample sample_on(const Grid& grid, const float* data, double x, double y, double z) noexcept {
    const Axis ax = axis(x, grid.origin.x, grid.cell, grid.cells.x);
    const Axis ay = axis(y, grid.origin.y, grid.cell, grid.cells.y);
    const Axis az = axis(z, grid.origin.z, grid.cell, grid.cells.z);
    const auto row = [&](int j, int k) {
      const double a = data[grid.index(ax.low, j, k)];
      return a + ax.t * (data[grid.index(ax.high, j, k)] - a);
    };
    const auto plane = [&](int k) {
      const double a = row(ay.low, k);
      return a + ay.t * (row(ay.high, k) - a);
    };
    const double a = plane(az.low);
    const double spread = ax.t * (1 - ax.t) + ay.t * (1 - ay.t) + az.t * (1 - az.t);
    const double outside =
        std::sqrt(ax.outside * ax.outside + ay.outside * ay.outside + az.outside * az.outside);
    return {a + az.t * (plane(az.high) - a), grid.cell * (std::sqrt(spread) + outside)};
  }

  struct Axis {
    int low, high;
    double t;        // from low to high
    double outside;  // cells from the point to the centres' box
  };

  static Axis axis(double value, float origin, float cell, int cells) noexcept {
    const double at = (value - origin) / cell - 0.5;
    const double last = cells - 1;
    const double inside = at > 0.0 ? (at < last ? at : last) : 0.0;
    const int low = static_cast<int>(inside);
    return {low, low + 1 < cells ? low + 1 : low, inside - low, std::fabs(at - inside)};
  }
};

}  // namespace mayfly
