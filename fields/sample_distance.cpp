#include "fields/sample_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "fields/double8.hpp"
#include "fields/geometry_parts.hpp"
#include "fields/parallel.hpp"
#include "fields/solid_rows.hpp"

namespace mayfly::fields {

// Fills the grid bundle by bundle: two by two rows of cells along x, taken eight cells (2 × 2 × 2) at a time.
// Each bundle starts afresh, so its bits depend on nothing but its place. Inside a bundle, the triangle
// nearest to one eight is the first guess for the next, and most of the tree is never visited.
class DistanceBuilder {
 public:
  DistanceBuilder(const Geometry& geometry, const SampleBox& samples, std::span<float> values)
      : parts_(geometry.parts()),
        samples_(samples),
        cells_(samples.cells()),
        values_(values),
        rows_(parts_.solids, samples) {}

  std::size_t bundles() const { return across() * static_cast<std::size_t>((cells_.z + 1) / 2); }

  void fill(std::size_t bundle) {
    const int j = 2 * static_cast<int>(bundle % across());
    const int k = 2 * static_cast<int>(bundle / across());
    Hints hints{{},
                std::vector<std::uint32_t>(parts_.solids.size(), TriangleTree::kNoHint),
                std::vector<std::uint32_t>(parts_.shells.size(), TriangleTree::kNoHint)};
    std::array<std::vector<int>, 4> rows;
    for (int row = 0; row < 4; ++row) {
      rows[static_cast<std::size_t>(row)] =
          rows_.owners(std::min(j + row % 2, cells_.y - 1), std::min(k + row / 2, cells_.z - 1));
    }
    for (int i = 0; i < cells_.x; i += 2) {
      const Eight cells = eight(i, j, k);
      Owners owners{};
      for (std::size_t lane = 0; lane < 8; ++lane) {
        owners[lane] = rows[lane / 2][static_cast<std::size_t>(cells.cell[lane].x)];
      }
      std::array<double, 8> distance = solids(cells, owners, hints);
      add_shells(cells, hints.shells, distance);
      add_primitives(cells, distance);
      store(cells, distance);
    }
  }

 private:
  // Of the eight cells before.
  struct Hints {
    std::size_t nearest_solid = 0;
    std::vector<std::uint32_t> solids, shells;  // their nearest triangle
  };
  struct Eight {
    std::array<glm::ivec3, 8> cell;  // those beyond the grid's far side repeat the last one
    std::array<Double8, 3> center;
  };

  std::size_t across() const { return static_cast<std::size_t>((cells_.y + 1) / 2); }

  Eight eight(int i, int j, int k) const {
    Eight cells{};
    for (int lane = 0; lane < 8; ++lane) {
      const glm::ivec3 cell =
          glm::min(glm::ivec3(i + lane % 2, j + lane / 2 % 2, k + lane / 4), cells_ - glm::ivec3(1));
      cells.cell[static_cast<std::size_t>(lane)] = cell;
      const glm::dvec3 center = samples_.center(cell.x, cell.y, cell.z);
      for (int axis = 0; axis < 3; ++axis) {
        cells.center[static_cast<std::size_t>(axis)].set(lane, center[axis]);
      }
    }
    return cells;
  }

  using Owners = std::array<int, 8>;

  std::array<double, 8> solids(const Eight& cells, const Owners& owners, Hints& hints) const {
    Double8 squared = limits(cells, owners);
    Double8 nearest = splat<Double8>(-1.0);
    // First the one that was nearest to the eight before: it leaves the others little to search.
    const std::size_t first = hints.nearest_solid;
    for (std::size_t turn = 0; turn < parts_.solids.size(); ++turn) {
      const std::size_t s = turn == 0 ? first : turn <= first ? turn - 1 : turn;
      const Double8 before = squared;
      parts_.solids[s].nearest(cells.center, squared, hints.solids[s]);
      nearest = select(squared < before, splat<Double8>(static_cast<double>(s)), nearest);
    }
    hints.nearest_solid = static_cast<std::size_t>(std::max(nearest[0], 0.0));
    std::array<double, 8> distance{};
    for (int lane = 0; lane < 8; ++lane) {
      const auto l = static_cast<std::size_t>(lane);
      distance[l] = one_solid(cells, lane, owners[l], static_cast<int>(nearest[lane]), squared[lane]);
    }
    return distance;
  }

  // Squared distances beyond which a cell outside is not lowered.
  Double8 limits(const Eight& cells, const Owners& owners) const {
    Double8 squared{};
    for (int lane = 0; lane < 8; ++lane) {
      const glm::ivec3 cell = cells.cell[static_cast<std::size_t>(lane)];
      const double value = static_cast<double>(values_[samples_.index(cell.x, cell.y, cell.z)]);
      const double reach = std::max(value + samples_.margin, 0.0);
      const bool outside = owners[static_cast<std::size_t>(lane)] == SolidRows::kNobody;
      squared.set(lane, outside ? reach * reach : std::numeric_limits<double>::infinity());
    }
    return squared;
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
      float& value = values_[samples_.index(cell.x, cell.y, cell.z)];
      value = std::min(value, static_cast<float>(distance[lane] - samples_.margin));
    }
  }

  const Geometry::Parts& parts_;
  const SampleBox& samples_;
  glm::ivec3 cells_;
  std::span<float> values_;
  SolidRows rows_;
};

namespace {

// Of primitives alone.
void lower_plane(std::span<const Primitive> primitives, const SampleBox& samples, int k,
                 std::span<float> values) {
  const glm::ivec3 cells = samples.cells();
  for (int j = 0; j < cells.y; ++j) {
    for (int i = 0; i < cells.x; ++i) {
      const glm::dvec3 center = samples.center(i, j, k);
      float& value = values[samples.index(i, j, k)];
      for (const Primitive& primitive : primitives) {
        value = std::min(value, static_cast<float>(signed_distance(primitive, center) - samples.margin));
      }
    }
  }
}

}  // namespace

CellBox cells_around(const Box& bounds, float reach, const Grid& grid) {
  CellBox cells;
  for (int axis = 0; axis < 3; ++axis) {
    // In double and clamped before it becomes a whole number: a shape may be far away, or endless.
    const double cell = static_cast<double>(grid.cell);
    const double origin = static_cast<double>(grid.origin[axis]);
    const double around = static_cast<double>(reach) / cell + 1.0;
    const double low = (static_cast<double>(bounds.min[axis]) - origin) / cell - around;
    const double high = (static_cast<double>(bounds.max[axis]) - origin) / cell + around + 1.0;
    const auto count = static_cast<double>(grid.cells[axis]);
    cells.first[axis] = static_cast<int>(std::clamp(low, 0.0, count));
    cells.end[axis] = static_cast<int>(std::clamp(high, 0.0, count));
  }
  return cells;
}

void fill_box(const Grid& grid, const CellBox& box, float value, std::span<float> values) {
  for (int k = box.first.z; k < box.end.z; ++k) {
    for (int j = box.first.y; j < box.end.y; ++j) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(grid.index(0, j, k));
      std::fill(row + box.first.x, row + std::max(box.first.x, box.end.x), value);
    }
  }
}

void lower_to_distance(const Geometry& geometry, const SampleBox& samples, int threads,
                       const Progress& progress, std::span<float> values) {
  if (geometry.empty() || samples.box.empty()) {
    return;
  }
  const Geometry::Parts& parts = geometry.parts();
  if (parts.solids.empty() && parts.shells.empty()) {
    const auto planes = static_cast<std::size_t>(samples.cells().z);
    parallel_for(planes, threads, "distance", progress,
                 [&](std::size_t k) { lower_plane(parts.primitives, samples, static_cast<int>(k), values); });
    return;
  }
  DistanceBuilder builder(geometry, samples, values);
  parallel_for(builder.bundles(), threads, "distance", progress, [&](std::size_t i) { builder.fill(i); });
}

}  // namespace mayfly::fields
