// The shapes of which a world is made: obstacles, goals and start regions, as plain data in SI units.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <variant>

#include "core/grid.hpp"

namespace mayfly::fields {

struct MeshShape {
  std::filesystem::path file;  // absolute, checked to be inside the project or the scenario's tree
  glm::vec3 position{0.0F};    // m
  glm::vec3 rotation{0.0F};    // degrees about x, y, z, applied in that order (extrinsic)
  float scale = 1.0F;          // mesh units → m
  // m: centre the mesh's bounding box on `position` and make its longest side this long
  std::optional<float> fit;
  bool thin = false;               // an open surface: unsigned distance, a shell of `thickness`
  std::optional<float> thickness;  // m, of a thin shell; default one cell
};
struct BoxShape {
  Box box;
};
struct SphereShape {
  glm::vec3 center{0.0F};
  float radius = 1.0F;
};
struct CylinderShape {  // capped
  glm::vec3 from{0.0F};
  glm::vec3 to{0.0F, 0.0F, 1.0F};
  float radius = 1.0F;
};
struct HalfSpaceShape {  // solid where normal·x < offset
  glm::vec3 normal{0.0F, 0.0F, 1.0F};
  float offset = 0.0F;
};
using Shape = std::variant<MeshShape, BoxShape, SphereShape, CylinderShape, HalfSpaceShape>;

}  // namespace mayfly::fields
