#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "controller/scenario/build.hpp"

namespace mayfly {

std::optional<PathSpec> build_path(const Values& shape, Findings& findings) {
  if (!shape.has("path")) {
    return std::nullopt;
  }
  const Values values = shape.map("path");
  PathSpec path;
  for (const YamlNode& item : values.node("points")->items) {
    path.points.push_back(values.element("points", item).whole_vector());
  }
  path.speed = values.number_f("speed");
  path.loop = values.flag("loop");
  path.place = shape.mark("path").place();
  if (std::all_of(path.points.begin(), path.points.end(),
                  [&](glm::vec3 point) { return point == path.points.front(); })) {
    findings.error(values.mark("points"), "this path leads nowhere", "the same point again and again",
                   "points at two places or more");
  }
  return path;
}

// Meshes are only known when the fields are built: whoever builds them looks again.
void check_goal_path(const Values& values, const GoalSpec& goal, const Box& bounds, Findings& findings) {
  const std::optional<Box> shape = box_around(goal.shape);
  if (!goal.path || !shape) {
    return;
  }
  if (const auto outside = goal.path->first_point_outside(*shape, bounds)) {
    const YamlNode& point = values.map("path").node("points")->items[*outside];
    const glm::vec3 by = goal.path->points[*outside] - goal.path->points.front();
    const glm::vec3 low = shape->min + by;
    const glm::vec3 high = shape->max + by;
    findings.error(point.mark, fmt::format("goal '{}' leaves world.bounds on its path", goal.name),
                   fmt::format("it reaches from [{:g}, {:g}, {:g}] to [{:g}, {:g}, {:g}] there", low.x, low.y,
                               low.z, high.x, high.y, high.z),
                   "points at which the whole goal lies inside");
  }
}

}  // namespace mayfly
