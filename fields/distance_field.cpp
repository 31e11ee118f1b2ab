#include "fields/distance_field.hpp"

#include <new>

#include "fields/hash.hpp"
#include "fields/make_grid.hpp"
#include "fields/sample_distance.hpp"

namespace mayfly::fields {

Result<DistanceField> build_distance_field(const Geometry& geometry, const Grid& grid, int threads,
                                           const Progress& progress) try {
  if (auto good = check_grid(grid); !good) {
    return fail(std::move(good.error()));
  }
  DistanceField field{grid, std::vector<float>(grid.size(), kNoObstacle)};
  lower_to_distance(geometry, {grid, {glm::ivec3(0), grid.cells}}, threads, progress, field.distance);
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
