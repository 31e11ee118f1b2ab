// A coarse grid over a whole world, with bricks of fine cells where they matter: what the fields of a large
// world share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "core/grid.hpp"

namespace mayfly {

// A regular grid, and the entry of a table at which its values start: cell (i,j,k) has entry first +
// grid.index(i,j,k).
struct Lattice {
  Grid grid;
  std::size_t first = 0;

  std::size_t entry(glm::ivec3 at) const { return first + grid.index(at.x, at.y, at.z); }
  glm::vec3 center(glm::ivec3 at) const { return grid.center(at.x, at.y, at.z); }
};

// Tables hold one entry for each coarse cell, x fastest; then, brick by brick, kBrickEntries fine ones, x
// fastest. A brick fills one coarse cell with kRatio³ fine cells, and has an apron of one cell all around,
// so that eight cells for a trilinear look-up or 27 for a quadratic spline lie in one brick.
struct NestedGrid {
  static constexpr int kRatio = 8;
  static constexpr int kBrickSide = kRatio + 2;
  static constexpr int kBrickEntries = kBrickSide * kBrickSide * kBrickSide;
  static constexpr int kNoBrick = -1;

  Grid coarse;
  std::vector<int> brick;  // one a coarse cell: the entry at which its brick starts, or kNoBrick
  std::size_t bricks = 0;

  // A cell in which a field is solved: a coarse one without a brick, or a fine one of a brick's core.
  struct Leaf {
    std::size_t entry;
    glm::vec3 center;  // m
    float side;        // m
  };

  bool empty() const { return brick.empty(); }
  float cell() const { return coarse.cell / static_cast<float>(kRatio); }
  std::size_t entries() const { return coarse.size() + bricks * std::size_t{kBrickEntries}; }
  // The fine grid that the bricks are cut from, over the whole world; far too large to hold values.
  Grid fine() const { return {coarse.origin, cell(), coarse.cells * kRatio}; }

  bool holds(glm::ivec3 at) const {
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < coarse.cells.x && at.y < coarse.cells.y &&
           at.z < coarse.cells.z;
  }
  int brick_at(glm::ivec3 at) const { return brick[coarse.index(at.x, at.y, at.z)]; }
  glm::vec3 corner(glm::ivec3 at) const { return coarse.origin + coarse.cell * glm::vec3(at); }

  // The coarse cell that holds p; the nearest one for a point outside, some one for a NaN.
  glm::ivec3 coarse_cell(glm::vec3 p) const {
    glm::ivec3 at(0);
    for (int axis = 0; axis < 3; ++axis) {
      const float u = (p[axis] - coarse.origin[axis]) / coarse.cell;
      // Negated: a NaN counts as low.
      at[axis] = !(u > 0.0F) ? 0 : static_cast<int>(std::min(u, static_cast<float>(coarse.cells[axis] - 1)));
    }
    return at;
  }

  Lattice coarse_lattice() const { return {coarse, 0}; }
  // The brick's cells with the apron: its core is cells 1 … kRatio.
  Lattice brick_lattice(glm::ivec3 at) const {
    return {{corner(at) - cell(), cell(), glm::ivec3(kBrickSide)}, static_cast<std::size_t>(brick_at(at))};
  }
  // What a look-up at p reads.
  Lattice lattice_at(glm::vec3 p) const {
    const glm::ivec3 at = coarse_cell(p);
    return brick_at(at) == kNoBrick ? coarse_lattice() : brick_lattice(at);
  }

  // visit(coarse cell) for those of plane z.
  void for_each_in_plane(int z, const auto& visit) const {
    for (int y = 0; y < coarse.cells.y; ++y) {
      for (int x = 0; x < coarse.cells.x; ++x) {
        visit(glm::ivec3(x, y, z));
      }
    }
  }
  // visit(local cell) for the core of a brick.
  static void for_each_in_core(const auto& visit) {
    for (int k = 1; k <= kRatio; ++k) {
      for (int j = 1; j <= kRatio; ++j) {
        for (int i = 1; i <= kRatio; ++i) {
          visit(glm::ivec3(i, j, k));
        }
      }
    }
  }
  // visit(Leaf) for the leaves in one coarse cell.
  void for_each_leaf_in(glm::ivec3 at, const auto& visit) const {
    if (brick_at(at) == kNoBrick) {
      const Lattice all = coarse_lattice();
      visit(Leaf{all.entry(at), all.center(at), coarse.cell});
      return;
    }
    const Lattice own = brick_lattice(at);
    for_each_in_core([&](glm::ivec3 local) {
      visit(Leaf{own.entry(local), own.center(local), own.grid.cell});
    });
  }
  void for_each_leaf(const auto& visit) const {
    for (int z = 0; z < coarse.cells.z; ++z) {
      for_each_in_plane(z, [&](glm::ivec3 at) { for_each_leaf_in(at, visit); });
    }
  }
};

}  // namespace mayfly
