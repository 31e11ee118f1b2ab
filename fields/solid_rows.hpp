// Which closed mesh, if any, each cell of a box of a grid lies in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fields/sample_distance.hpp"
#include "fields/triangle_tree.hpp"

namespace mayfly::fields {

// Crosses every row of cell centres along x with every triangle, once (fields/scan_lines.hpp), and answers
// row by row.
class SolidRows {
 public:
  static constexpr int kNobody = -1;
  static constexpr int kSeveral = -2;

  SolidRows(std::span<const TriangleTree> solids, const SampleBox& samples);

  // For each cell of row (·, j, k): the index of the solid its centre lies in, kNobody, or kSeveral where
  // solids overlap.
  std::vector<int> owners(int j, int k) const;

 private:
  struct Crossing {
    double x;
    int passes;
    std::uint32_t solid;
  };

  void cross(std::span<const TriangleTree> solids, const auto& visit) const;
  void cross_triangle(const TriangleTree::Corners& t, const auto& visit) const;
  void claim(std::vector<int>& row, double from, double to, int solid) const;
  std::size_t row_index(int j, int k) const {
    return static_cast<std::size_t>(j) + static_cast<std::size_t>(cells_.y) * static_cast<std::size_t>(k);
  }

  SampleBox samples_;
  glm::ivec3 cells_;
  std::vector<std::size_t> first_;   // of each row's crossings; one more at the end
  std::vector<Crossing> crossings_;  // by row, then solid, then x
};

}  // namespace mayfly::fields
