// The ways of what moves by a script.
#pragma once

#include "controller/scenario/scenario.hpp"
#include "record/plot_canvas.hpp"
#include "record/plot_layout.hpp"

namespace mayfly::record {

// Dashed lines along which the middles of goals and obstacles move, and stimuli; these where they start.
void draw_motion(Canvas& canvas, const Panel& panel, const Scenario& scenario);

}  // namespace mayfly::record
