// The edges of a mesh, each with the triangles that share it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fields/mesh.hpp"

namespace mayfly::fields {

// One triangle's use of the edge between vertices low < high: direction +1 where it runs low → high, else −1.
struct EdgeUse {
  std::uint32_t low, high, triangle;
  int direction;
};

// Uses of the same edge stand together.
std::vector<EdgeUse> edge_uses(const TriangleMesh& mesh);

// Calls visit(span of the uses of one edge) for each edge.
void for_each_edge(std::span<const EdgeUse> uses, const auto& visit) {
  for (std::size_t first = 0; first < uses.size();) {
    std::size_t end = first + 1;
    while (end < uses.size() && uses[end].low == uses[first].low && uses[end].high == uses[first].high) {
      ++end;
    }
    visit(uses.subspan(first, end - first));
    first = end;
  }
}

// Loops of the edges that an odd number of triangles share.
std::vector<Hole> find_holes(const TriangleMesh& mesh, std::span<const EdgeUse> uses);

// part[t]: a number that triangles of the same part share, below the number of parts. Triangles that share an
// edge are of one part, but bodies that only touch along an edge (an even number of triangles each, running
// both ways) are parts of their own.
struct PartList {
  std::vector<std::uint32_t> of_triangle;
  std::size_t count = 0;
};
PartList find_parts(const TriangleMesh& mesh, std::span<const EdgeUse> uses);

// six_volumes[p] of each part, positive where its triangles face outwards; and whether a part that is not
// positive stands free (is no cavity of a larger one): then it is inside out.
std::vector<bool> find_inside_out(const TriangleMesh& mesh, const PartList& parts);

}  // namespace mayfly::fields
