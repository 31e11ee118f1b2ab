#include "fields/distance_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <new>

#include "fields/double8.hpp"
#include "fields/geometry_parts.hpp"
#include "fields/hash.hpp"
#include "fields/make_grid.hpp"
#include "fields/parallel.hpp"
#include "fields/solid_rows.hpp"

namespace mayfly::fields {

// Fills the grid bundle by bundle: two by two rows of cells along x, taken eight cells (2 × 2 × 2) at a time.
// Each bundle starts afresh, so its bits depend on nothing but its place. Inside a bundle, the triangle
// nearest to one eight is the first guess for the next, and most of the tree is never visited.
class DistanceBuilder {
 public:
  DistanceBuilder(const Geometry& geometry, DistanceField& field)
      : parts_(*geometry.parts_), field_(field), rows_(parts_.solids, field.grid) {}

  std::size_t bundles() const { return across() * static_cast<std::size_t>((field_.grid.cells.z + 1) / 2); }

  void fill(std::size_t bundle) {
    const int j = 2 * static_cast<int>(bundle % across());
    const int k = 2 * static_cast<int>(bundle / across());
    std::vector<std::uint32_t> solid_hints(parts_.solids.size(), TriangleTree::kNoHint);
    std::vector<std::uint32_t> shell_hints(parts_.shells.size(), TriangleTree::kNoHint);
    std::array<std::vector<int>, 4> owners;
    for (int row = 0; row < 4; ++row) {
      owners[static_cast<std::size_t>(row)] = rows_.owners(std::min(j + row % 2, field_.grid.cells.y - 1),
                                                           std::min(k + row / 2, field_.grid.cells.z - 1));
    }
    for (int i = 0; i < field_.grid.cells.x; i += 2) {
      const Eight cells = eight(i, j, k);
      std::array<double, 8> distance = solids(cells, owners, solid_hints);
      add_shells(cells, shell_hints, distance);
      add_primitives(cells, distance);
      store(cells, distance);
    }
  }

 private:
  struct Eight {
    std::array<glm::ivec3, 8> cell;  // those beyond the grid's far side repeat the last one
    std::array<Double8, 3> center;
  };

  std::size_t across() const { return static_cast<std::size_t>((field_.grid.cells.y + 1) / 2); }

  Eight eight(int i, int j, int k) const {
    Eight cells{};
    for (int lane = 0; lane < 8; ++lane) {
      const glm::ivec3 cell = glm::min(glm::ivec3(i + lane % 2, j + lane / 2 % 2, k + lane / 4),
                                       field_.grid.cells - glm::ivec3(1));
      cells.cell[static_cast<std::size_t>(lane)] = cell;
      const glm::vec3 center = field_.grid.center(cell.x, cell.y, cell.z);
      for (int axis = 0; axis < 3; ++axis) {
        cells.center[static_cast<std::size_t>(axis)].set(lane, static_cast<double>(center[axis]));
      }
    }
    return cells;
  }

  std::array<double, 8> solids(const Eight& cells, const std::array<std::vector<int>, 4>& owners,
                               std::vector<std::uint32_t>& hints) const {
    Double8 squared = splat<Double8>(std::numeric_limits<double>::infinity());
    Double8 nearest = splat<Double8>(-1.0);
    for (std::size_t s = 0; s < parts_.solids.size(); ++s) {
      const Double8 before = squared;
      parts_.solids[s].nearest(cells.center, squared, hints[s]);
      nearest = select(squared < before, splat<Double8>(static_cast<double>(s)), nearest);
    }
    std::array<double, 8> distance{};
    for (int lane = 0; lane < 8; ++lane) {
      const auto l = static_cast<std::size_t>(lane);
      const int owner = owners[l / 2][static_cast<std::size_t>(cells.cell[l].x)];
      distance[l] = one_solid(cells, lane, owner, static_cast<int>(nearest[lane]), squared[lane]);
    }
    return distance;
  }

  // The nearest triangle overall answers for every cell outside, and for a cell inside one solid when it is
  // that solid's.
  double one_solid(const Eight& cells, int lane, int owner, int nearest, double squared) const {
    if (parts_.solids.empty()) {
      return static_cast<double>(kNoObstacle);
    }
    if (owner == SolidRows::kNobody) {
      return std::min(std::sqrt(squared), static_cast<double>(kNoObstacle));
    }
    if (owner == nearest) {
      return -std::sqrt(squared);
    }
    return parts_.solid_distance({cells.center[0][lane], cells.center[1][lane], cells.center[2][lane]});
  }

  void add_shells(const Eight& cells, std::vector<std::uint32_t>& hints,
                  std::array<double, 8>& distance) const {
    for (std::size_t s = 0; s < parts_.shells.size(); ++s) {
      const Shell& shell = parts_.shells[s];
      Double8 limit{};
      for (int lane = 0; lane < 8; ++lane) {
        const double reach = std::max(distance[static_cast<std::size_t>(lane)] + shell.half_thickness, 0.0);
        limit.set(lane, reach * reach);
      }
      Double8 squared = limit;
      shell.tree.nearest(cells.center, squared, hints[s]);
      for (int lane = 0; lane < 8; ++lane) {
        if (squared[lane] < limit[lane]) {
          distance[static_cast<std::size_t>(lane)] = std::sqrt(squared[lane]) - shell.half_thickness;
        }
      }
    }
  }

  void add_primitives(const Eight& cells, std::array<double, 8>& distance) const {
    for (const Primitive& primitive : parts_.primitives) {
      for (int lane = 0; lane < 8; ++lane) {
        double& here = distance[static_cast<std::size_t>(lane)];
        here = std::min(here, signed_distance(primitive, {cells.center[0][lane], cells.center[1][lane],
                                                          cells.center[2][lane]}));
      }
    }
  }

  void store(const Eight& cells, const std::array<double, 8>& distance) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const glm::ivec3 cell = cells.cell[lane];
      field_.distance[field_.grid.index(cell.x, cell.y, cell.z)] = static_cast<float>(distance[lane]);
    }
  }

  const Geometry::Parts& parts_;
  DistanceField& field_;
  SolidRows rows_;
};

Result<DistanceField> build_distance_field(const Geometry& geometry, const Grid& grid, int threads,
                                           const Progress& progress) try {
  if (grid.cells.x < 1 || grid.cells.y < 1 || grid.cells.z < 1 || grid.size() > kMaxCells) {
    return fail(Error{Cause::kCaller,
                      "the distance field's grid is empty or too large",
                      std::nullopt,
                      std::to_string(grid.size()) + " cells",
                      "1 to " + std::to_string(kMaxCells),
                      {}});
  }
  DistanceField field{grid, std::vector<float>(grid.size(), kNoObstacle)};
  if (!geometry.empty()) {
    DistanceBuilder builder(geometry, field);
    parallel_for(builder.bundles(), threads, "distance", progress, [&](std::size_t i) { builder.fill(i); });
  }
  return field;
} catch (const std::bad_alloc&) {
  return fail(Cause::kEnvironment,
              "there is not enough memory for a distance field of " + std::to_string(grid.size()) + " cells");
}

std::string distance_key(const Geometry& geometry, const Grid& grid) {
  constexpr int kMethod = 1;  // to be raised when the same input gives other numbers
  ContentHash hash;
  for (int axis = 0; axis < 3; ++axis) {
    hash.add(grid.origin[axis]).add(grid.cells[axis]);
  }
  hash.add(grid.cell).add(kMethod).add(geometry.content_hash());
  return "distance " + hash.hex();
}

}  // namespace mayfly::fields
