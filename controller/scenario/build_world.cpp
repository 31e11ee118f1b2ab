#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "controller/scenario/build.hpp"

namespace mayfly {
namespace {

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

std::vector<PlaneSpec> build_fence(const Values& world, Findings& findings) {
  std::vector<PlaneSpec> fence;
  const YamlNode* planes = world.node("fence");
  for (std::size_t n = 0; planes != nullptr && n < planes->items.size(); ++n) {
    const Values values = world.element("fence", planes->items[n]);
    const glm::vec3 normal = values.vector("normal");
    const float length = glm::length(normal);
    if (length < 1e-6F) {
      findings.error(values.mark("normal"), "this normal has no direction", "", "a vector that is not zero");
      continue;
    }
    fence.push_back({normal / length, values.number_f("offset")});
  }
  return fence;
}

// A nested grid's coarse cells must be made of whole fine ones.
void check_coarse_cell(const Values& world, const WorldSpec& spec, Findings& findings) {
  constexpr double kRounding = 1e-4;  // of the two sides, as they are written
  const double ratio = static_cast<double>(*spec.coarse_cell) / static_cast<double>(spec.cell);
  const double whole = std::max(2.0, std::round(ratio));
  if (std::fabs(ratio - whole) > kRounding * whole) {
    findings.error(world.mark("coarse_cell"), "this is no whole multiple of world.cell",
                   fmt::format("{:g} m, of cells of {:g} m", *spec.coarse_cell, spec.cell),
                   "at least 2 cells, and no part of one",
                   fmt::format("{:.6g}", whole * static_cast<double>(spec.cell)));
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

// m; of a mesh it is only known when the fields are built.
std::optional<float> narrowest(const fields::Shape& shape) {
  if (const auto* box = std::get_if<fields::BoxShape>(&shape)) {
    const glm::vec3 size = box->box.max - box->box.min;
    return std::min({size.x, size.y, size.z});
  }
  if (const auto* sphere = std::get_if<fields::SphereShape>(&shape)) {
    return 2.0F * sphere->radius;
  }
  if (const auto* cylinder = std::get_if<fields::CylinderShape>(&shape)) {
    return 2.0F * cylinder->radius;
  }
  return std::nullopt;
}

// Between samples that all lie outside nothing is seen of what lies among them: agents would fly into it.
void warn_if_narrow(const ObstacleSpec& obstacle, const YamlMark& mark, float cell, Findings& findings) {
  const std::optional<float> width = narrowest(obstacle.shape);
  if (width && *width > 0.0F && *width < cell) {
    findings.warn(mark, fmt::format("an obstacle {:g} m across may not be seen between samples {:g} m apart; "
                                    "agents may fly into it",
                                    *width, cell));
  }
}

ObstacleSpec build_obstacle(const Values& values, const YamlMark& mark, const FileRoots& roots,
                            Findings& findings) {
  ObstacleSpec obstacle{build_shape(values, roots, findings), mark.place(), build_path(values, findings)};
  if (obstacle.path && std::holds_alternative<fields::HalfSpaceShape>(obstacle.shape)) {
    findings.error(values.mark("path"), "a half-space has no end, and cannot move", "",
                   "'path' only beside another shape");
  }
  return obstacle;
}

}  // namespace

std::optional<Box> box_around(const fields::Shape& shape) {
  if (const auto* box = std::get_if<fields::BoxShape>(&shape)) {
    return box->box;
  }
  if (const auto* sphere = std::get_if<fields::SphereShape>(&shape)) {
    return Box{sphere->center - sphere->radius, sphere->center + sphere->radius};
  }
  return std::nullopt;
}

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
  spec.fence = build_fence(world, findings);
  spec.coarse_cell = world.maybe_number("coarse_cell");
  if (spec.coarse_cell) {
    check_coarse_cell(world, spec, findings);
  }
  if (const YamlNode* obstacles = world.node("obstacles")) {
    for (const YamlNode& item : obstacles->items) {
      spec.obstacles.push_back(build_obstacle(world.element("obstacles", item), item.mark, roots, findings));
      warn_if_narrow(spec.obstacles.back(), item.mark, spec.cell, findings);
    }
  }
  if (const YamlNode* goals = world.node("goals")) {
    for (const YamlEntry& entry : goals->entries) {
      const std::size_t before = findings.errors.size();
      const Values values = world.element("goals", entry.value);
      spec.goals.push_back({entry.key, build_shape(values, roots, findings), entry.mark.place(),
                            build_path(values, findings)});
      if (has_bounds && findings.errors.size() == before) {
        check_goal_in_bounds(spec.goals.back(), entry.mark, spec.bounds, findings);
        check_goal_path(values, spec.goals.back(), spec.bounds, findings);
      }
    }
  }
  return spec;
}

}  // namespace mayfly
