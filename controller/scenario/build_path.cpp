#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "controller/scenario/build.hpp"

namespace mayfly {
namespace {

void check_points(const Values& values, const std::vector<glm::vec3>& points, Findings& findings) {
  if (std::all_of(points.begin(), points.end(), [&](glm::vec3 point) { return point == points.front(); })) {
    findings.error(values.mark("points"), "this path leads nowhere", "the same point again and again",
                   "points at two places or more");
    return;
  }
  if (const auto twice = std::adjacent_find(points.begin(), points.end()); twice != points.end()) {
    const YamlNode& second =
        values.node("points")->items[static_cast<std::size_t>(twice - points.begin()) + 1];
    findings.error(second.mark, "this point of a path is the one before it again",
                   fmt::format("[{:g}, {:g}, {:g}]", twice->x, twice->y, twice->z),
                   "another point: nothing waits on a path");
  }
}

}  // namespace

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
  check_points(values, path.points, findings);
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
