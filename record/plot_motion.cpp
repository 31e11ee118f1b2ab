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

void draw_path(Canvas& canvas, const Panel& panel, const std::optional<PathSpec>& way, glm::vec3 start,
               const Stroke& stroke) {
  if (!way || way->points.empty()) {
    return;
  }
  const PathSpec& path = *way;
  std::vector<glm::dvec2> line;
  for (const glm::vec3 point : path.points) {
    line.push_back(panel.at(start + (point - path.points.front())));
  }
  if (path.loop) {
    line.push_back(panel.at(start));
  }
  canvas.line(line, stroke);
}

template <class Spec>
void draw_way(Canvas& canvas, const Panel& panel, const Spec& spec, const Stroke& stroke) {
  draw_path(canvas, panel, spec.path, std::visit(Middle{}, spec.shape), stroke);
}

// Where it starts, and its way.
void draw_stimulus(Canvas& canvas, const Panel& panel, const StimulusSpec& stimulus) {
  if (stimulus.kind == StimulusSpec::Kind::kAhead) {
    return;
  }
  const Color color = stimulus.kind == StimulusSpec::Kind::kPredator ? kBad : kGoal;
  draw_path(canvas, panel, stimulus.path, stimulus.position, {color, 1.8, 1.0, 9.0});
  canvas.dot(panel.at(stimulus.position), 5.0, color, {kInk, 0.9, 0.75});
}

}  // namespace

void draw_motion(Canvas& canvas, const Panel& panel, const Scenario& scenario) {
  const WorldSpec& world = scenario.world;
  for (const StimulusSpec& stimulus : scenario.stimuli) {
    draw_stimulus(canvas, panel, stimulus);
  }
  for (const ObstacleSpec& obstacle : world.obstacles) {
    draw_way(canvas, panel, obstacle, {kInk, 1.6, 0.8, 9.0});
  }
  for (const GoalSpec& goal : world.goals) {
    draw_way(canvas, panel, goal, {kGoal, 1.8, 1.0, 9.0});
  }
}

}  // namespace mayfly::record
