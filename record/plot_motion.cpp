#include "record/plot_motion.hpp"

#include <variant>
#include <vector>

namespace mayfly::record {
namespace {

struct Middle {
  glm::vec3 operator()(const fields::MeshShape& mesh) const { return mesh.position; }
  glm::vec3 operator()(const fields::BoxShape& box) const { return 0.5F * (box.box.min + box.box.max); }
  glm::vec3 operator()(const fields::SphereShape& sphere) const { return sphere.center; }
  glm::vec3 operator()(const fields::CylinderShape& cylinder) const {
    return 0.5F * (cylinder.from + cylinder.to);
  }
  glm::vec3 operator()(const fields::HalfSpaceShape&) const { return glm::vec3(0.0F); }
};

template <class Spec>
void draw_way(Canvas& canvas, const Panel& panel, const Spec& spec, const Stroke& stroke) {
  if (!spec.path || spec.path->points.empty()) {
    return;
  }
  const PathSpec& path = *spec.path;
  const glm::vec3 start = std::visit(Middle{}, spec.shape);
  std::vector<glm::dvec2> line;
  for (const glm::vec3 point : path.points) {
    line.push_back(panel.at(start + (point - path.points.front())));
  }
  if (path.loop) {
    line.push_back(panel.at(start));
  }
  canvas.line(line, stroke);
}

}  // namespace

void draw_motion(Canvas& canvas, const Panel& panel, const WorldSpec& world) {
  for (const ObstacleSpec& obstacle : world.obstacles) {
    draw_way(canvas, panel, obstacle, {kInk, 1.6, 0.8, 9.0});
  }
  for (const GoalSpec& goal : world.goals) {
    draw_way(canvas, panel, goal, {kGoal, 1.8, 1.0, 9.0});
  }
}

}  // namespace mayfly::record
