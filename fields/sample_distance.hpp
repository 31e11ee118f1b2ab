// The distance to a solid, sampled in a box of a grid's cells, wherever the solid has been moved to.
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/grid.hpp"
#include "core/progress.hpp"
#include "fields/geometry.hpp"

namespace mayfly::fields {

// Half open.
struct CellBox {
  glm::ivec3 first{0};
  glm::ivec3 end{0};

  bool empty() const { return first.x >= end.x || first.y >= end.y || first.z >= end.z; }
};

// The cells whose centres may lie within `reach` (m) of `bounds`, and one more around.
CellBox cells_around(const Box& bounds, float reach, const Grid& grid);

// Sets `values`, one a cell of the whole grid, in the cells of the box.
void fill_box(const Grid& grid, const CellBox& box, float value, std::span<float> values);

// Where a sample is taken: the centre of a cell, seen from a solid that has been moved by `offset`.
struct SampleBox {
  Grid grid;
  CellBox box;
  glm::dvec3 offset{0.0};  // m
  double margin = 0.0;     // m, by which the solid is taken to be larger

  glm::ivec3 cells() const { return box.end - box.first; }
  // i, j, k are counted from the box's first cell.
  glm::dvec3 center(int i, int j, int k) const {
    return glm::dvec3(grid.center(box.first.x + i, box.first.y + j, box.first.z + k)) - offset;
  }
  std::size_t index(int i, int j, int k) const {
    return grid.index(box.first.x + i, box.first.y + j, box.first.z + k);
  }
};

// Lowers `values`, one a cell of the whole grid, to the signed distance wherever that is less, in the cells
// of the box. Exact, rounded once; the same bits whatever the number of threads (< 1: all cores). Throws
// std::bad_alloc.
void lower_to_distance(const Geometry& geometry, const SampleBox& samples, int threads,
                       const Progress& progress, std::span<float> values);

}  // namespace mayfly::fields
