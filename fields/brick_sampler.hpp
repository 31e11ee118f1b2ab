// The exact signed distance in bricks of fine cells. For nested_distance.cpp only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/nested_grid.hpp"
#include "fields/double8.hpp"
#include "fields/geometry.hpp"
#include "fields/solid_rows.hpp"

namespace mayfly::fields {

// Takes the bricks of a row of coarse cells at a time, eight fine cells (2 × 2 × 2) at a time. Every row
// starts afresh, so its bits depend on nothing but its place.
class BrickSampler {
 public:
  // `fine`: the fine grid over the whole world. Both outlive the sampler.
  BrickSampler(const Geometry& geometry, const Grid& fine);

  // φ (m) in the bricks of the coarse cells (x, y, z) for each x in `xs`: kBrickEntries numbers each, the
  // apron included. May run for several rows at once.
  void fill_row(std::span<const int> xs, int y, int z, std::span<float> out) const;

 private:
  static constexpr int kSide = NestedGrid::kBrickSide;

  // Of a row of fine cells among those of Row.
  static std::size_t row_index(int j, int k) {
    return static_cast<std::size_t>(j) + static_cast<std::size_t>(kSide) * static_cast<std::size_t>(k);
  }

  // What a row of bricks shares: which solid each fine cell of its kSide × kSide rows lies in, and the
  // triangles found last.
  struct Row {
    std::vector<std::vector<int>> owners;
    std::vector<std::uint32_t> solid_hints, shell_hints;
    std::vector<std::size_t> primitives;  // that can be the nearest one somewhere in the brick
  };
  struct Eight {
    std::array<glm::ivec3, 8> local;
    std::array<glm::ivec3, 8> cell;  // on the fine grid; the apron's may lie outside it
    std::array<Double8, 3> center;

    glm::dvec3 point(int lane) const { return {center[0][lane], center[1][lane], center[2][lane]}; }
  };

  Row start_row(int y, int z) const;
  void fill_brick(glm::ivec3 first, Row& row, std::span<float> out) const;
  std::vector<std::size_t> near_primitives(glm::ivec3 first) const;
  Eight eight(glm::ivec3 first, glm::ivec3 local) const;
  std::array<double, 8> solids(const Eight& cells, Row& row) const;
  double one_solid(const Eight& cells, int lane, const Row& row, int nearest, double squared) const;
  void add_shells(const Eight& cells, Row& row, std::array<double, 8>& distance) const;
  void add_primitives(const Eight& cells, const Row& row, std::array<double, 8>& distance) const;

  const Geometry::Parts& parts_;
  const Grid& fine_;
  SolidRows rows_;
};

}  // namespace mayfly::fields
