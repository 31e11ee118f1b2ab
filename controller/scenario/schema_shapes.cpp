#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

void add_mesh_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back({.path = path + ".mesh",
                  .type = KeyType::kFile,
                  .group = "shape",
                  .text = "A triangle mesh (OBJ, OFF, STL, PLY or glTF), closed unless `thin` is on."});
  rows.push_back({.path = path + ".position",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .fallback = "[0, 0, 0]",
                  .needs = "mesh",
                  .text = "Where the mesh's own origin goes, or its middle where `fit` is given."});
  rows.push_back({.path = path + ".rotation",
                  .type = KeyType::kVector,
                  .unit = "degrees",
                  .min = -360.0,
                  .max = 360.0,
                  .fallback = "[0, 0, 0]",
                  .needs = "mesh",
                  .text = "Turns the mesh about the world's x, y and z axes, in that order."});
  rows.push_back({.path = path + ".scale",
                  .type = KeyType::kNumber,
                  .unit = "m per mesh unit",
                  .min = 0.0,
                  .max = 1e6,
                  .above_min = true,
                  .fallback = "1.0",
                  .needs = "mesh",
                  .text = "How many metres one unit of the mesh file is."});
  rows.push_back(
      {.path = path + ".fit",
       .type = KeyType::kNumber,
       .unit = "m",
       .min = 0.0,
       .max = kFarthest,
       .above_min = true,
       .needs = "mesh",
       .text = "Scales the mesh until its longest side has this length, and puts its middle at `position`."});
  rows.push_back({.path = path + ".thin",
                  .type = KeyType::kFlag,
                  .fallback = "off",
                  .needs = "mesh",
                  .text = "Takes an open surface as a shell of `thickness`, instead of refusing it."});
  rows.push_back({.path = path + ".thickness",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback_text = "one cell",
                  .needs = "thin",
                  .text = "How thick a thin surface is."});
}

void add_box_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back(
      {.path = path + ".box", .type = KeyType::kMap, .group = "shape", .text = "An axis-aligned box."});
  rows.push_back({.path = path + ".box.min",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the smallest coordinates."});
  rows.push_back({.path = path + ".box.max",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the largest coordinates, larger than `min` in all three."});
}

void add_sphere_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back({.path = path + ".sphere", .type = KeyType::kMap, .group = "shape", .text = "A sphere."});
  rows.push_back({.path = path + ".sphere.center",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "Its centre."});
  rows.push_back({.path = path + ".sphere.radius",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = kFarthest,
                  .above_min = true,
                  .required = true,
                  .text = "Its radius."});
}

void add_cylinder_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back({.path = path + ".cylinder",
                  .type = KeyType::kMap,
                  .group = "shape",
                  .text = "A cylinder with flat ends."});
  rows.push_back({.path = path + ".cylinder.from",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The middle of one end."});
  rows.push_back({.path = path + ".cylinder.to",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The middle of the other end."});
  rows.push_back({.path = path + ".cylinder.radius",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.0,
                  .max = kFarthest,
                  .above_min = true,
                  .required = true,
                  .text = "Its radius."});
}

void add_half_space_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back({.path = path + ".half_space",
                  .type = KeyType::kMap,
                  .group = "shape",
                  .text = "Everything on one side of a plane: solid where normal · x < offset."});
  rows.push_back({.path = path + ".half_space.normal",
                  .type = KeyType::kVector,
                  .min = -1e6,
                  .max = 1e6,
                  .required = true,
                  .text = "Points out of the solid; its length does not matter."});
  rows.push_back({.path = path + ".half_space.offset",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "How far along the normal the surface is from the origin."});
}

}  // namespace

void add_path_rows(std::vector<Key>& rows, const std::string& path) {
  rows.push_back({.path = path,
                  .type = KeyType::kMap,
                  .text = "How it moves: it is where it is given at the start, and goes as the path goes."});
  rows.push_back({.path = path + ".points",
                  .type = KeyType::kList,
                  .min = 2,
                  .max = 10'000,
                  .required = true,
                  .text = "What the path joins with straight lines."});
  rows.push_back({.path = path + ".points[]",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .text = "One point."});
  rows.push_back({.path = path + ".speed",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .required = true,
                  .text = "The speed along the path."});
  rows.push_back(
      {.path = path + ".loop",
       .type = KeyType::kFlag,
       .fallback = "off",
       .text = "From the last point straight back to the first, for ever; otherwise it stays at the last."});
}

void add_shape_rows(std::vector<Key>& rows, const std::string& path, ShapeSet set) {
  if (set != ShapeSet::kStart) {
    add_mesh_rows(rows, path);
  }
  add_box_rows(rows, path);
  add_sphere_rows(rows, path);
  if (set == ShapeSet::kObstacle) {
    add_cylinder_rows(rows, path);
    add_half_space_rows(rows, path);
  }
  if (set != ShapeSet::kStart) {
    add_path_rows(rows, path + ".path");
  }
}

}  // namespace mayfly
