// Triangle meshes: read from a file, checked, closed, put into the world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "fields/shape.hpp"

namespace mayfly::fields {

struct TriangleMesh {
  std::vector<glm::vec3> vertices;    // m, or the file's units before transformed()
  std::vector<glm::uvec3> triangles;  // indices of vertices, counter-clockwise seen from outside
};

inline constexpr std::uintmax_t kMaxMeshBytes = std::uintmax_t{512} << 20;
inline constexpr std::size_t kMaxMeshVertices = 20'000'000;
inline constexpr std::size_t kMaxMeshTriangles = 10'000'000;

// Reads .obj, .off, .stl, .ply, .gltf or .glb (node transforms applied, skins ignored, every mesh of the file
// in one), welds vertices nearer than 1e-6 of the bounding box's diagonal, drops triangles that this makes
// degenerate. Errors name the file: wrong ending, not a regular file, too large, truncated, not what it says
// it is, without triangles, coordinates that are not finite, indices out of range. Files that a mesh refers
// to must lie in its own folder.
Result<TriangleMesh> load_mesh(const std::filesystem::path& file);

// Scale, or fit; then rotation, then position, as MeshShape has them.
Result<TriangleMesh> transformed(TriangleMesh mesh, const MeshShape& shape);

struct Hole {
  std::size_t edges = 0;
  glm::vec3 center{0.0F};  // of its bounding box
  float width = 0.0F;      // longest side of its bounding box
};

struct MeshReport {
  std::vector<Hole> holes;             // largest first: loops of edges that an odd number of triangles share
  std::size_t crowded_edges = 0;       // shared by more than two triangles
  std::size_t inconsistent_edges = 0;  // run through more often one way than the other, though not a hole's
  std::size_t components = 0;          // parts that share no edge
  std::size_t inside_out = 0;          // components, not within another, whose volume is negative

  bool closed() const { return holes.empty(); }
};

MeshReport check_closed(const TriangleMesh& mesh);

// "2 holes: a loop of 14 edges around (1.2, 0.3, 4), 0.31 m wide; …"
std::string describe_holes(const std::vector<Hole>& holes);

// A closed mesh whose triangles all face outwards: winding mended where the surface is orientable, components
// that are inside out turned (not cavities). Refused: an open mesh (its holes named), a surface with one side
// only. `name` is for the error.
Result<TriangleMesh> make_solid(TriangleMesh mesh, std::string_view name);

}  // namespace mayfly::fields
