// The parts of a panel.
#pragma once

#include <span>
#include <vector>

#include "controller/scenario/scenario.hpp"
#include "record/path_sampler.hpp"
#include "record/plot_canvas.hpp"
#include "record/plot_layout.hpp"

namespace mayfly::record {

// Round values from low to high, so that about `spacing` px lie between two at `scale` px a unit.
std::vector<double> round_ticks(double low, double high, double scale, double spacing);

void draw_grid(Canvas& canvas, const Panel& panel);
// Frame, tick labels, axis names: after everything that is clipped to the panel.
void draw_axes(Canvas& canvas, const Panel& panel);
// The outline of a start region or a goal, as seen in the panel's direction.
void draw_region(Canvas& canvas, const Panel& panel, const fields::Shape& shape, const Stroke& stroke);
// Coloured by time; where each agent was last, a dot.
void draw_paths(Canvas& canvas, const Panel& panel, std::span<const PathSampler::Row> rows);

}  // namespace mayfly::record
