#include "fields/brick_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/geometry_parts.hpp"

namespace mayfly::fields {

// Without a closed mesh nobody asks for rows.
BrickSampler::BrickSampler(const Geometry& geometry, const Grid& fine)
    : parts_(geometry.parts()),
      fine_(fine),
      rows_(parts_.solids, {fine, {glm::ivec3(0), parts_.solids.empty() ? glm::ivec3(0) : fine.cells}}) {}

void BrickSampler::fill_row(std::span<const int> xs, int y, int z, std::span<float> out) const {
  if (xs.empty()) {
    return;
  }
  Row row = start_row(y, z);
  for (std::size_t b = 0; b < xs.size(); ++b) {
    fill_brick(NestedGrid::kRatio * glm::ivec3(xs[b], y, z) - 1, row,
               out.subspan(b * NestedGrid::kBrickEntries, NestedGrid::kBrickEntries));
  }
}

BrickSampler::Row BrickSampler::start_row(int y, int z) const {
  Row row;
  row.solid_hints.assign(parts_.solids.size(), TriangleTree::kNoHint);
  row.shell_hints.assign(parts_.shells.size(), TriangleTree::kNoHint);
  row.owners.resize(std::size_t{kSide} * kSide);
  if (parts_.solids.empty()) {
    return row;
  }
  for (int k = 0; k < kSide; ++k) {
    for (int j = 0; j < kSide; ++j) {
      const int fine_j = NestedGrid::kRatio * y - 1 + j;
      const int fine_k = NestedGrid::kRatio * z - 1 + k;
      if (fine_j >= 0 && fine_j < fine_.cells.y && fine_k >= 0 && fine_k < fine_.cells.z) {
        row.owners[row_index(j, k)] = rows_.owners(fine_j, fine_k);
      }
    }
  }
  return row;
}

void BrickSampler::fill_brick(glm::ivec3 first, Row& row, std::span<float> out) const {
  row.primitives = near_primitives(first);
  const Grid own{glm::vec3(0.0F), fine_.cell, glm::ivec3(kSide)};
  for (int k = 0; k < kSide; k += 2) {
    for (int j = 0; j < kSide; j += 2) {
      for (int i = 0; i < kSide; i += 2) {
        const Eight cells = eight(first, {i, j, k});
        std::array<double, 8> distance = solids(cells, row);
        add_shells(cells, row, distance);
        add_primitives(cells, row, distance);
        for (std::size_t lane = 0; lane < 8; ++lane) {
          const glm::ivec3 at = cells.local[lane];
          out[own.index(at.x, at.y, at.z)] = static_cast<float>(distance[lane]);
        }
      }
    }
  }
}

void BrickSampler::add_primitives(const Eight& cells, const Row& row, std::array<double, 8>& distance) const {
  for (int lane = 0; lane < 8; ++lane) {
    double& least = distance[static_cast<std::size_t>(lane)];
    for (const std::size_t p : row.primitives) {
      least = std::min(least, signed_distance(parts_.primitives[p], cells.point(lane)));
    }
  }
}

// A distance changes by no more than the way: one that is larger in the middle than the least by more than
// twice the way to a corner is the least nowhere in the brick.
std::vector<std::size_t> BrickSampler::near_primitives(glm::ivec3 first) const {
  const double half = 0.5 * kSide;
  const glm::dvec3 middle =
      glm::dvec3(fine_.origin) + static_cast<double>(fine_.cell) * (glm::dvec3(first) + half);
  const double reach = 2.0 * std::sqrt(3.0) * half * static_cast<double>(fine_.cell);
  std::vector<double> distance(parts_.primitives.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < distance.size(); ++p) {
    distance[p] = signed_distance(parts_.primitives[p], middle);
    least = std::min(least, distance[p]);
  }
  std::vector<std::size_t> near;
  for (std::size_t p = 0; p < distance.size(); ++p) {
    if (distance[p] <= least + reach) {
      near.push_back(p);
    }
  }
  return near;
}

BrickSampler::Eight BrickSampler::eight(glm::ivec3 first, glm::ivec3 local) const {
  Eight cells{};
  for (int lane = 0; lane < 8; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    cells.local[l] = local + glm::ivec3(lane % 2, lane / 2 % 2, lane / 4);
    cells.cell[l] = first + cells.local[l];
    const glm::vec3 center = fine_.center(cells.cell[l].x, cells.cell[l].y, cells.cell[l].z);
    for (int axis = 0; axis < 3; ++axis) {
      cells.center[static_cast<std::size_t>(axis)].set(lane, static_cast<double>(center[axis]));
    }
  }
  return cells;
}

std::array<double, 8> BrickSampler::solids(const Eight& cells, Row& row) const {
  std::array<double, 8> distance{};
  distance.fill(static_cast<double>(kNoObstacle));
  if (parts_.solids.empty()) {
    return distance;
  }
  Double8 squared = splat<Double8>(std::numeric_limits<double>::infinity());
  Double8 nearest = splat<Double8>(-1.0);
  for (std::size_t s = 0; s < parts_.solids.size(); ++s) {
    const Double8 before = squared;
    parts_.solids[s].nearest(cells.center, squared, row.solid_hints[s]);
    nearest = select(squared < before, splat<Double8>(static_cast<double>(s)), nearest);
  }
  for (int lane = 0; lane < 8; ++lane) {
    distance[static_cast<std::size_t>(lane)] =
        one_solid(cells, lane, row, static_cast<int>(nearest[lane]), squared[lane]);
  }
  return distance;
}

// As in distance_field.cpp: the nearest triangle overall answers for every cell outside, and for a cell
// inside one solid when it is that solid's.
double BrickSampler::one_solid(const Eight& cells, int lane, const Row& row, int nearest,
                               double squared) const {
  const auto l = static_cast<std::size_t>(lane);
  const auto& owners = row.owners[row_index(cells.local[l].y, cells.local[l].z)];
  const int x = cells.cell[l].x;
  const bool known = x >= 0 && x < static_cast<int>(owners.size());
  const int owner = known ? owners[static_cast<std::size_t>(x)] : SolidRows::kSeveral;
  if (owner == SolidRows::kNobody) {
    return std::min(std::sqrt(squared), static_cast<double>(kNoObstacle));
  }
  return owner == nearest ? -std::sqrt(squared) : parts_.solid_distance(cells.point(lane));
}

void BrickSampler::add_shells(const Eight& cells, Row& row, std::array<double, 8>& distance) const {
  for (std::size_t s = 0; s < parts_.shells.size(); ++s) {
    const Shell& shell = parts_.shells[s];
    Double8 limit{};
    for (int lane = 0; lane < 8; ++lane) {
      const double reach = std::max(distance[static_cast<std::size_t>(lane)] + shell.half_thickness, 0.0);
      limit.set(lane, reach * reach);
    }
    Double8 squared = limit;
    shell.tree.nearest(cells.center, squared, row.shell_hints[s]);
    for (int lane = 0; lane < 8; ++lane) {
      if (squared[lane] < limit[lane]) {
        distance[static_cast<std::size_t>(lane)] = std::sqrt(squared[lane]) - shell.half_thickness;
      }
    }
  }
}

}  // namespace mayfly::fields
