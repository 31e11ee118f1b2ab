#include "record/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "record/chart_scale.hpp"

namespace mayfly::record {
namespace {

constexpr double kLeft = 70.0;  // px, of tick labels and the axis' name
constexpr double kRight = 14.0;
constexpr double kTitle = 30.0;
constexpr double kLegendRow = 21.0;
constexpr double kBelow = 48.0;
constexpr double kTickSpacing = 62.0;
constexpr TextStyle kTickStyle{13.0, kMutedInk};
constexpr TextStyle kLegendStyle{13.5, kInk};

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  void add(double value, bool positive_only) {
    if (std::isfinite(value) && (value > 0.0 || !positive_only)) {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
};

// A little room beyond the data, so that nothing lies on the frame.
ChartScale scale_of(const Axis& axis, const Range& range) {
  const double room = axis.logarithmic ? 0.0 : 0.04 * (range.most - range.least);
  const double factor = axis.logarithmic ? 1.15 : 1.0;
  return {axis.least.value_or((range.least - room) / factor),
          axis.most.value_or((range.most + room) * factor), axis.logarithmic};
}

// The axes of one chart, and where they are on the canvas.
struct Frame {
  Rectangle area;  // within the axes
  ChartScale x, y;
  Frame(const Rectangle& within, const ChartScale& along, const ChartScale& up)
      : area(within), x(along), y(up) {}
  glm::dvec2 at(glm::dvec2 p) const {
    return {area.x + area.width * x.fraction(p.x), area.y + area.height * (1.0 - y.fraction(p.y))};
  }
};

double crisp(double at) {
  return std::floor(at) + 0.5;
}

void draw_y_axis(Canvas& canvas, const Frame& frame, const Axis& axis) {
  const Rectangle& area = frame.area;
  for (const Tick& tick : frame.y.ticks(area.height, kTickSpacing)) {
    const double y = crisp(area.y + area.height * (1.0 - frame.y.fraction(tick.value)));
    canvas.line(std::array{glm::dvec2(area.x, y), glm::dvec2(area.x + area.width, y)},
                {kGridLine, tick.label.empty() ? 0.5 : 1.0});
    TextStyle style = kTickStyle;
    style.align = Align::kRight;
    canvas.text({area.x - 7.0, y + 4.5}, tick.label, style);
  }
  canvas.text({area.x - kLeft + 17.0, area.y + area.height / 2}, axis.name,
              {14.0, kInk, false, Align::kCenter, true});
}

void draw_x_axis(Canvas& canvas, const Frame& frame, const Axis& axis) {
  const Rectangle& area = frame.area;
  const double below = area.y + area.height;
  for (const Tick& tick : frame.x.ticks(area.width, kTickSpacing)) {
    const double x = crisp(area.x + area.width * frame.x.fraction(tick.value));
    canvas.line(std::array{glm::dvec2(x, area.y), glm::dvec2(x, below)},
                {kGridLine, tick.label.empty() ? 0.5 : 1.0});
    TextStyle style = kTickStyle;
    style.align = Align::kCenter;
    canvas.text({x, below + 18.0}, tick.label, style);
  }
  canvas.text({area.x + area.width / 2, below + 39.0}, axis.name, {14.0, kInk, false, Align::kCenter});
}

// Entries in rows, each as full as it may be. Without a canvas to draw on, only counts the rows.
int lay_legend(Canvas& canvas, const Chart& chart, glm::dvec2 at, double width, bool draw) {
  int rows = 0;
  double x = width;
  for (const Series& series : chart.series) {
    if (series.name.empty()) {
      continue;
    }
    const double needed = 30.0 + canvas.text_width(series.name, kLegendStyle) + 18.0;
    if (x + needed > width) {
      x = 0.0;
      ++rows;
    }
    const glm::dvec2 left{at.x + x, at.y + kLegendRow * (rows - 1)};
    if (draw) {
      if (series.stroke.width > 0.0) {
        canvas.line(std::array{left + glm::dvec2(0.0, -4.5), left + glm::dvec2(22.0, -4.5)}, series.stroke);
      }
      if (series.dot_radius > 0.0) {
        canvas.dot(left + glm::dvec2(11.0, -4.5), std::min(series.dot_radius, 5.0), series.stroke.color,
                   {kPaper, 0.8});
      }
      canvas.text(left + glm::dvec2(29.0, 0.0), series.name, kLegendStyle);
    }
    x += needed;
  }
  return rows;
}

void draw_series(Canvas& canvas, const Frame& frame, const Series& series) {
  std::vector<glm::dvec2> piece;
  const auto end_piece = [&] {
    if (piece.size() > 1 && series.stroke.width > 0.0) {
      canvas.line(piece, series.stroke);
    }
    piece.clear();
  };
  for (const glm::dvec2& point : series.points) {
    if (frame.x.shows(point.x) && frame.y.shows(point.y)) {
      piece.push_back(frame.at(point));
    } else {
      end_piece();
    }
  }
  end_piece();
  for (const glm::dvec2& point : series.points) {
    if (series.dot_radius > 0.0 && frame.x.shows(point.x) && frame.y.shows(point.y)) {
      canvas.dot(frame.at(point), series.dot_radius, series.stroke.color, {kPaper, 0.8});
    }
  }
}

void draw_patches(Canvas& canvas, const Frame& frame, const Chart& chart) {
  for (const Patch& patch : chart.patches) {
    const glm::dvec2 a = frame.at({patch.least.x, patch.most.y});
    const glm::dvec2 b = frame.at({patch.most.x, patch.least.y});
    const Rectangle area{a.x, a.y, b.x - a.x, b.y - a.y};
    if (patch.outlined) {
      canvas.frame(area, {patch.color, 1.6});
    } else {
      canvas.fill(area, patch.color);
    }
  }
}

// The largest part of `area` in which a unit is as long along x as along y, in its middle.
Rectangle fitted(const Rectangle& area, const ChartScale& x, const ChartScale& y) {
  const double wide = x.most() - x.least();
  const double high = y.most() - y.least();
  const double scale = std::min(area.width / wide, area.height / high);
  return {area.x + 0.5 * (area.width - scale * wide), area.y, scale * wide, scale * high};
}

Rectangle inside(const Rectangle& area, double above) {
  return {area.x + kLeft, area.y + above, std::max(area.width - kLeft - kRight, 1.0),
          std::max(area.height - above - kBelow, 1.0)};
}

void draw_title(Canvas& canvas, const Rectangle& area, const std::string& title) {
  canvas.text({area.x + kLeft, area.y + 18.0}, title, {16.0, kInk, true});
}

void draw_bar(Canvas& canvas, const Frame& frame, const Bar& bar, double left, double width) {
  const double bottom = frame.area.y + frame.area.height;
  const double middle = left + width / 2;
  const auto height_of = [&](double value) {
    return frame.y.shows(value) ? frame.area.height * std::clamp(frame.y.fraction(value), 0.0, 1.0) : 0.0;
  };
  const double high = height_of(bar.value);
  canvas.fill({left, bottom - high, width, high}, bar.color);
  if (bar.range) {
    canvas.line(std::array{glm::dvec2(middle, bottom - height_of(bar.range->x)),
                           glm::dvec2(middle, bottom - height_of(bar.range->y))},
                {kInk, 1.4});
  }
  TextStyle style = kTickStyle;
  style.align = Align::kCenter;
  glm::dvec2 at{middle, bottom + 18.0};
  std::size_t from = 0;
  while (from <= bar.name.size()) {
    const std::size_t end = std::min(bar.name.find('\n', from), bar.name.size());
    canvas.text(at, bar.name.substr(from, end - from), style);
    from = end + 1;
    at.y += 16.0;
  }
}

}  // namespace

Color series_color(std::size_t index) {
  static constexpr std::array<Color, 7> kColors{
      Color{0.00, 0.45, 0.70}, Color{0.84, 0.37, 0.00}, Color{0.00, 0.62, 0.45}, Color{0.80, 0.47, 0.65},
      Color{0.90, 0.62, 0.00}, Color{0.34, 0.71, 0.91}, Color{0.30, 0.30, 0.32}};
  return kColors[index % kColors.size()];
}

void draw_chart(Canvas& canvas, const Rectangle& area, const Chart& chart) {
  Range x, y;
  for (const Series& series : chart.series) {
    for (const glm::dvec2& point : series.points) {
      x.add(point.x, chart.x.logarithmic);
      y.add(point.y, chart.y.logarithmic);
    }
  }
  const double wide = area.width - kLeft - kRight;
  const int rows = lay_legend(canvas, chart, {}, wide, false);
  Frame frame{inside(area, kTitle + kLegendRow * rows), scale_of(chart.x, x), scale_of(chart.y, y)};
  if (chart.same_scale) {
    frame.area = fitted(frame.area, frame.x, frame.y);
  }
  draw_title(canvas, area, chart.title);
  lay_legend(canvas, chart, {area.x + kLeft, area.y + kTitle + 11.0}, wide, true);
  draw_x_axis(canvas, frame, chart.x);
  draw_y_axis(canvas, frame, chart.y);
  canvas.clip(frame.area);
  draw_patches(canvas, frame, chart);
  for (const Series& series : chart.series) {
    draw_series(canvas, frame, series);
  }
  canvas.unclip();
  canvas.frame(
      {crisp(frame.area.x), crisp(frame.area.y), std::floor(frame.area.width), std::floor(frame.area.height)},
      {kFrame});
}

void draw_bars(Canvas& canvas, const Rectangle& area, const BarChart& chart) {
  Range y;
  for (const Bar& bar : chart.bars) {
    y.add(bar.value, chart.y.logarithmic);
    y.add(bar.range ? bar.range->y : bar.value, chart.y.logarithmic);
  }
  y.add(chart.reference.value_or(y.most), chart.y.logarithmic);
  Axis axis = chart.y;
  if (!axis.logarithmic && !axis.least) {
    axis.least = std::min(0.0, y.least);
  }
  const Frame frame{inside(area, kTitle), {0.0, 1.0, false}, scale_of(axis, y)};
  draw_title(canvas, area, chart.title);
  draw_y_axis(canvas, frame, chart.y);
  const double step = frame.area.width / std::max(1.0, static_cast<double>(chart.bars.size()));
  for (std::size_t i = 0; i < chart.bars.size(); ++i) {
    draw_bar(canvas, frame, chart.bars[i], frame.area.x + (static_cast<double>(i) + 0.16) * step,
             0.68 * step);
  }
  if (chart.reference && frame.y.shows(*chart.reference)) {
    const double at = crisp(frame.at({0.0, *chart.reference}).y);
    canvas.line(std::array{glm::dvec2(frame.area.x, at), glm::dvec2(frame.area.x + frame.area.width, at)},
                {kInk, 1.2, 0.8, 5.0});
  }
  const double bottom = crisp(frame.area.y + frame.area.height);
  canvas.line(
      std::array{glm::dvec2(frame.area.x, bottom), glm::dvec2(frame.area.x + frame.area.width, bottom)},
      {kFrame});
}

}  // namespace mayfly::record
