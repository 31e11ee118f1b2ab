#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "controller/scenario/build.hpp"

namespace mayfly {
namespace {

// Distance, cost, and two columns of scratch while they are built: bytes for each cell of the grid.
constexpr double kBytesPerCell = 16.0;
constexpr double kMaxGridBytes = 4e9;

Box build_box(const Values& values, Findings& findings) {
  const Box box{values.vector("min"), values.vector("max")};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] < box.max[axis])) {
      findings.error(values.mark("max"), fmt::format("this box is empty along {}", "xyz"[axis]),
                     fmt::format("min {:g} and max {:g}", box.min[axis], box.max[axis]),
                     "max larger than min");
      break;
    }
  }
  return box;
}

fields::Shape build_mesh(const Values& values, const FileRoots& roots, Findings& findings) {
  fields::MeshShape mesh;
  auto file = resolve_file(*values.node("mesh"), roots);
  if (file) {
    mesh.file = std::move(*file);
  } else {
    findings.errors.push_back(std::move(file.error()));
  }
  if (values.has("fit") && values.has("scale")) {
    findings.error(values.mark("scale"), "'scale' and 'fit' both say how large the mesh is", "",
                   "one of the two");
  }
  mesh.position = values.vector("position");
  mesh.rotation = values.vector("rotation");
  mesh.scale = values.number_f("scale");
  mesh.fit = values.maybe_number("fit");
  mesh.thin = values.flag("thin");
  mesh.thickness = values.maybe_number("thickness");
  return mesh;
}

fields::Shape build_cylinder(const Values& values, Findings& findings) {
  fields::CylinderShape cylinder{values.vector("from"), values.vector("to"), values.number_f("radius")};
  if (glm::distance(cylinder.from, cylinder.to) < 1e-6F) {
    findings.error(values.mark("to"), "this cylinder has no length", "", "'to' away from 'from'");
  }
  return cylinder;
}

fields::Shape build_half_space(const Values& values, Findings& findings) {
  const glm::vec3 normal = values.vector("normal");
  const float length = glm::length(normal);
  if (length < 1e-6F) {
    findings.error(values.mark("normal"), "this normal has no direction", "", "a vector that is not zero");
  }
  return fields::HalfSpaceShape{length < 1e-6F ? glm::vec3(0.0F, 0.0F, 1.0F) : normal / length,
                                values.number_f("offset")};
}

// The least cell side, to two digits, with which the grid fits the cap.
double cell_that_fits(const glm::dvec3& size) {
  double cell = std::cbrt(size.x * size.y * size.z * kBytesPerCell / kMaxGridBytes);
  const double step = std::pow(10.0, std::floor(std::log10(cell)) - 1.0);
  cell = std::ceil(cell / step) * step;
  const auto bytes = [&] {
    return std::ceil(size.x / cell) * std::ceil(size.y / cell) * std::ceil(size.z / cell) * kBytesPerCell;
  };
  while (bytes() > kMaxGridBytes) {
    cell += step;
  }
  return cell;
}

void check_grid(const Values& world, const WorldSpec& spec, Findings& findings) {
  const glm::dvec3 size = glm::dvec3(spec.bounds.max) - glm::dvec3(spec.bounds.min);
  const double cells =
      std::ceil(size.x / spec.cell) * std::ceil(size.y / spec.cell) * std::ceil(size.z / spec.cell);
  if (cells * kBytesPerCell > kMaxGridBytes) {
    findings.error(world.mark("cell"), "the grid of these bounds and this cell is too large",
                   fmt::format("{:.3g} cells, {:.3g} GB", cells, cells * kBytesPerCell / 1e9),
                   fmt::format("at most {:g} GB: a cell of {:.6g} m or more", kMaxGridBytes / 1e9,
                               cell_that_fits(size)));
  }
}

bool overlaps(const Box& a, const Box& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y &&
         a.min.z < b.max.z && b.min.z < a.max.z;
}

// Meshes are only known when the fields are built: whoever builds them looks again.
void check_goal_in_bounds(const GoalSpec& goal, const YamlMark& mark, const Box& bounds, Findings& findings) {
  bool is_inside = true;
  if (const auto* box = std::get_if<fields::BoxShape>(&goal.shape)) {
    is_inside = overlaps(box->box, bounds);
  } else if (const auto* sphere = std::get_if<fields::SphereShape>(&goal.shape)) {
    const glm::vec3 nearest = glm::clamp(sphere->center, bounds.min, bounds.max);
    is_inside = glm::distance(nearest, sphere->center) < sphere->radius;
  }
  if (!is_inside) {
    findings.error(mark, fmt::format("goal '{}' lies outside world.bounds", goal.name), "",
                   "a goal that agents can fly to");
  }
}

}  // namespace

fields::Shape build_shape(const Values& values, const FileRoots& roots, Findings& findings) {
  if (values.has("mesh")) {
    return build_mesh(values, roots, findings);
  }
  if (values.has("sphere")) {
    const Values sphere = values.map("sphere");
    return fields::SphereShape{sphere.vector("center"), sphere.number_f("radius")};
  }
  if (values.has("cylinder")) {
    return build_cylinder(values.map("cylinder"), findings);
  }
  if (values.has("half_space")) {
    return build_half_space(values.map("half_space"), findings);
  }
  return fields::BoxShape{build_box(values.map("box"), findings)};
}

WorldSpec build_world(const Values& world, const FileRoots& roots, Findings& findings) {
  WorldSpec spec;
  const std::size_t errors_before = findings.errors.size();
  spec.bounds = build_box(world.map("bounds"), findings);
  spec.cell = world.number_f("cell");
  const bool has_bounds = findings.errors.size() == errors_before;
  if (has_bounds) {
    check_grid(world, spec, findings);
  }
  if (const YamlNode* obstacles = world.node("obstacles")) {
    for (const YamlNode& item : obstacles->items) {
      spec.obstacles.push_back(
          {build_shape(world.element("obstacles", item), roots, findings), item.mark.place()});
    }
  }
  for (const YamlEntry& entry : world.node("goals")->entries) {
    const std::size_t before = findings.errors.size();
    spec.goals.push_back(
        {entry.key, build_shape(world.element("goals", entry.value), roots, findings), entry.mark.place()});
    if (has_bounds && findings.errors.size() == before) {
      check_goal_in_bounds(spec.goals.back(), entry.mark, spec.bounds, findings);
    }
  }
  return spec;
}

}  // namespace mayfly
