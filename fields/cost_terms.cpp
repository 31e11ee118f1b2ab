#include "fields/cost_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <string>

#include "core/finite.hpp"
#include "kernels/ramp.h"

namespace mayfly::fields {
namespace {

constexpr int kSpread = 4;  // cells along an axis over which one agent is spread

struct Spread {
  std::array<int, kSpread> cell;
  std::array<float, kSpread> weight;
};

int mirrored(int cell, int count) {
  const int inside = cell < 0 ? -1 - cell : cell >= count ? 2 * count - 1 - cell : cell;
  return std::clamp(inside, 0, count - 1);  // in a grid of one cell the mirror image is outside, too
}

// u: cell coordinates, whole at the lower faces, in [0, count].
Spread spread(float u, int count) {
  const float from_centers = u - 0.5F;
  const float low = std::floor(from_centers);
  const float t = from_centers - low;
  Spread s{};
  s.weight = {0.25F * (1.0F - t), 0.25F * (2.0F - t), 0.25F * (1.0F + t), 0.25F * t};
  for (int i = 0; i < kSpread; ++i) {
    s.cell[static_cast<std::size_t>(i)] = mirrored(static_cast<int>(low) - 1 + i, count);
  }
  return s;
}

void add_agent(glm::vec3 u, const Grid& grid, float share, std::span<float> density) {
  const Spread x = spread(u.x, grid.cells.x);
  const Spread y = spread(u.y, grid.cells.y);
  const Spread z = spread(u.z, grid.cells.z);
  for (std::size_t k = 0; k < kSpread; ++k) {
    for (std::size_t j = 0; j < kSpread; ++j) {
      const float row_share = share * y.weight[j] * z.weight[k];
      float* row = density.data() + grid.index(0, y.cell[j], z.cell[k]);
      for (std::size_t i = 0; i < kSpread; ++i) {
        row[x.cell[i]] += row_share * x.weight[i];
      }
    }
  }
}

Result<void> check_size(std::size_t found, std::size_t wanted) {
  if (found != wanted) {
    return fail(Error{Cause::kCaller,
                      "a column of a cost's terms has another size than what it goes with",
                      std::nullopt,
                      std::to_string(found) + " values",
                      std::to_string(wanted),
                      {}});
  }
  return {};
}

Result<void> check_brush(const CostBrush& brush) {
  if (finite(brush.center) && std::isfinite(brush.strength) && std::isfinite(brush.radius) &&
      brush.radius > 0.0F) {
    return {};
  }
  return fail(Error{Cause::kCaller,
                    "a brush has no extent or strength",
                    std::nullopt,
                    "radius " + std::to_string(brush.radius) + ", strength " + std::to_string(brush.strength),
                    "finite numbers, a radius above 0",
                    {}});
}

void add_brush(const CostBrush& brush, const Grid& grid, std::span<float> extra) {
  glm::ivec3 first;
  glm::ivec3 end;
  for (int axis = 0; axis < 3; ++axis) {
    // In double and clamped before it becomes a whole number: a brush may be far away, or huge.
    const double middle = (static_cast<double>(brush.center[axis]) - static_cast<double>(grid.origin[axis])) /
                          static_cast<double>(grid.cell);
    const double reach = static_cast<double>(brush.radius) / static_cast<double>(grid.cell) + 1.0;
    const auto count = static_cast<double>(grid.cells[axis]);
    first[axis] = static_cast<int>(std::clamp(middle - reach, 0.0, count));
    end[axis] = static_cast<int>(std::clamp(middle + reach + 1.0, 0.0, count));
  }
  for (int k = first.z; k < end.z; ++k) {
    for (int j = first.y; j < end.y; ++j) {
      for (int i = first.x; i < end.x; ++i) {
        const float away = glm::length(grid.center(i, j, k) - brush.center);
        if (away < brush.radius) {
          extra[grid.index(i, j, k)] +=
              brush.strength * kernels::mf_bell(kernels::mf_splat(away / brush.radius))[0];
        }
      }
    }
  }
}

}  // namespace

Result<void> bin_density(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                         const Grid& grid, std::span<float> density) {
  if (auto good = check_size(y.size(), x.size()); !good) {
    return good;
  }
  if (auto good = check_size(z.size(), x.size()); !good) {
    return good;
  }
  if (auto good = check_size(density.size(), grid.size()); !good) {
    return good;
  }
  std::fill(density.begin(), density.end(), 0.0F);
  const float share = 1.0F / (grid.cell * grid.cell * grid.cell);
  const glm::vec3 cells(grid.cells);
  for (std::size_t agent = 0; agent < x.size(); ++agent) {
    const glm::vec3 u = (glm::vec3(x[agent], y[agent], z[agent]) - grid.origin) / grid.cell;
    // Not a number fails every comparison.
    const bool inside =
        u.x >= 0.0F && u.y >= 0.0F && u.z >= 0.0F && u.x <= cells.x && u.y <= cells.y && u.z <= cells.z;
    if (inside) {
      add_agent(u, grid, share, density);
    }
  }
  return {};
}

Result<void> add_density(float weight, std::span<const float> density, std::span<float> extra_slowness) {
  if (auto good = check_size(extra_slowness.size(), density.size()); !good) {
    return good;
  }
  for (std::size_t cell = 0; cell < density.size(); ++cell) {
    extra_slowness[cell] += weight * density[cell];
  }
  return {};
}

Result<void> add_brushes(std::span<const CostBrush> brushes, const Grid& grid,
                         std::span<float> extra_slowness) {
  if (auto good = check_size(extra_slowness.size(), grid.size()); !good) {
    return good;
  }
  for (const CostBrush& brush : brushes) {
    if (auto good = check_brush(brush); !good) {
      return good;
    }
  }
  for (const CostBrush& brush : brushes) {
    add_brush(brush, grid, extra_slowness);
  }
  return {};
}

}  // namespace mayfly::fields
