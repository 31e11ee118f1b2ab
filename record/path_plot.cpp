#include "record/path_plot.hpp"

#include "record/plot_drawing.hpp"
#include "record/plot_header.hpp"
#include "record/plot_motion.hpp"

namespace mayfly::record {
namespace {

void draw_panel(Canvas& canvas, const Panel& panel, const Scenario& scenario,
                std::span<const Triangle> solids, std::span<const PathSampler::Row> rows) {
  draw_grid(canvas, panel);
  canvas.image(draw_relief(solids, panel), panel.area);
  canvas.clip(panel.area);
  for (const SwarmSpec& swarm : scenario.swarms) {
    draw_region(canvas, panel, swarm.start, {kStart, 1.6, 1.0, 6.0});
  }
  draw_paths(canvas, panel, rows);
  for (const GoalSpec& goal : scenario.world.goals) {
    draw_region(canvas, panel, goal.shape, {kGoal, 2.4});
  }
  draw_motion(canvas, panel, scenario);
  canvas.unclip();
  draw_axes(canvas, panel);
}

}  // namespace

Result<std::string> draw_path_plot(const Scenario& scenario, const Summary& summary,
                                   const PathSampler& paths) {
  const Layout layout = lay_out(scenario.world.bounds);
  auto solids = triangles_of(scenario.world.obstacles, scenario.world.bounds);
  if (!solids) {
    return fail(std::move(solids.error()));
  }
  auto canvas = Canvas::create(layout.width, layout.height);
  if (!canvas) {
    return fail(std::move(canvas.error()));
  }
  const auto rows = paths.rows();
  draw_header(*canvas, layout.header, summary, rows.empty() ? summary.simulated_s : rows.back().time_s);
  for (const Panel& panel : layout.panels) {
    draw_panel(*canvas, panel, scenario, *solids, rows);
  }
  return canvas->png();
}

}  // namespace mayfly::record
