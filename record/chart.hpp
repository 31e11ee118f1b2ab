// Charts for figures: lines and points on linear or logarithmic axes, and bars. Several may share a canvas.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "record/plot_canvas.hpp"

namespace mayfly::record {

// Unlike each other for every kind of colour vision, and on paper without colour (after Okabe and Ito 2008).
Color series_color(std::size_t index);

struct Axis {
  std::string name;  // with its unit: "agents", "time (ms)"
  bool logarithmic = false;
  std::optional<double> least{}, most{};  // default: what the data need
};

struct Series {
  std::string name;                     // in the legend; empty: it has no entry there
  std::vector<glm::dvec2> points;       // those that are no numbers break the line
  Stroke stroke{series_color(0), 2.2};  // no line where its width is 0
  double dot_radius = 0.0;              // px; no dots at 0
};

// A rectangle behind the lines, in the axes' units: an obstacle, a range that is meant.
struct Patch {
  glm::dvec2 least{0.0}, most{0.0};
  Color color = kGridLine;
  bool outlined = false;  // only its edge
};

struct Chart {
  std::string title;
  Axis x{}, y{};
  std::vector<Series> series{};
  std::vector<Patch> patches{};
  bool same_scale = false;  // a unit is as long along x as along y: a map
};

struct Bar {
  std::string name;  // written below, a new line at each '\n'
  double value = 0.0;
  std::optional<glm::dvec2> range{};  // of repeated measurements: a thin line from .x to .y
  Color color = series_color(0);
};

struct BarChart {
  std::string title;
  Axis y;  // from 0 where it is linear and has no `least`
  std::vector<Bar> bars{};
  std::optional<double> reference{};  // a dashed line: what is wanted, or what chance would give
};

// `area` (px) holds all of it: title, legend, axes' names.
void draw_chart(Canvas& canvas, const Rectangle& area, const Chart& chart);
void draw_bars(Canvas& canvas, const Rectangle& area, const BarChart& chart);

}  // namespace mayfly::record
