// What stands above the panels: what was flown, what it came to, and what the colours mean.
#pragma once

#include "controller/flight/summary.hpp"
#include "record/plot_canvas.hpp"

namespace mayfly::record {

void draw_header(Canvas& canvas, const Rectangle& area, const Summary& summary, double end_s);

}  // namespace mayfly::record
