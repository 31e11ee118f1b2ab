// Vertices that stand in one place, made one.
#pragma once

#include "fields/mesh.hpp"

namespace mayfly::fields {

// Files split vertices along seams, and round them. Merges those nearer than 1e-6 of the bounding box's
// diagonal, drops triangles that thereby lose a corner, and vertices that no triangle uses.
void weld(TriangleMesh& mesh);

}  // namespace mayfly::fields
