#include "record/plot_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <variant>

#include "core/finite.hpp"
#include "record/plot_solids.hpp"

namespace mayfly::record {
namespace {

constexpr double kTickSpacing = 95.0;  // px
constexpr int kOutlinePoints = 73;
constexpr std::array<const char*, 3> kAxisNames{"x (m)", "y (m)", "z (m)"};

std::string tick_label(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", std::abs(value) < 1e-9 ? 0.0 : value);
  return text.data();
}

std::vector<double> ticks_along(const Panel& panel, int axis) {
  return round_ticks(panel.bounds.min[axis], panel.bounds.max[axis], panel.scale, kTickSpacing);
}

double x_of(const Panel& panel, double value) {
  return panel.area.x + panel.scale * (value - panel.bounds.min[panel.view.right]);
}
double y_of(const Panel& panel, double value) {
  glm::vec3 world = panel.bounds.min;
  world[panel.view.up] = static_cast<float>(value);
  return panel.at(world).y;
}

// Lines of one pixel are sharp between pixels.
double crisp(double at) {
  return std::floor(at) + 0.5;
}

void horizontal(Canvas& canvas, double y, double from, double to, const Stroke& stroke) {
  canvas.line(std::array{glm::dvec2(from, crisp(y)), glm::dvec2(to, crisp(y))}, stroke);
}
void vertical(Canvas& canvas, double x, double from, double to, const Stroke& stroke) {
  canvas.line(std::array{glm::dvec2(crisp(x), from), glm::dvec2(crisp(x), to)}, stroke);
}

void frame_box(Canvas& canvas, const Panel& panel, const Box& box, const Stroke& stroke) {
  const glm::dvec2 a = panel.at(box.min);
  const glm::dvec2 b = panel.at(box.max);
  const glm::dvec2 corner = glm::min(a, b);
  const glm::dvec2 size = glm::abs(b - a);
  canvas.frame({corner.x, corner.y, size.x, size.y}, stroke);
}

void frame_sphere(Canvas& canvas, const Panel& panel, const fields::SphereShape& sphere,
                  const Stroke& stroke) {
  const glm::dvec2 center = panel.at(sphere.center);
  const double radius = panel.scale * static_cast<double>(sphere.radius);
  std::vector<glm::dvec2> points;
  for (int i = 0; i < kOutlinePoints; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / (kOutlinePoints - 1);
    points.push_back(center + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  canvas.line(points, stroke);
}

// Fewer agents can be drawn more firmly.
double path_alpha(std::size_t paths) {
  return std::clamp(5.5 / std::sqrt(static_cast<double>(paths) + 1.0), 0.12, 0.9);
}

// A path in pieces of a few rows, each of one colour; pieces overlap in one point so that lines go on.
void draw_piece(Canvas& canvas, const Panel& panel, std::span<const PathSampler::Row> rows, std::size_t path,
                const Stroke& stroke) {
  std::vector<glm::dvec2> points;
  for (const PathSampler::Row& row : rows) {
    if (finite(row.positions[path])) {
      points.push_back(panel.at(row.positions[path]));
    }
  }
  if (points.size() > 1) {
    canvas.line(points, stroke);
  }
}

}  // namespace

std::vector<double> round_ticks(double low, double high, double scale, double spacing) {
  const double wanted = spacing / scale;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= wanted) {
      step = factor * power;
    }
  }
  std::vector<double> ticks;
  for (auto k = static_cast<int>(std::ceil(low / step - 1e-6)); k * step <= high + 1e-6 * step; ++k) {
    ticks.push_back(k * step);
  }
  return ticks;
}

void draw_grid(Canvas& canvas, const Panel& panel) {
  const Rectangle& area = panel.area;
  for (const double tick : ticks_along(panel, panel.view.right)) {
    vertical(canvas, x_of(panel, tick), area.y, area.y + area.height, {kGridLine});
  }
  for (const double tick : ticks_along(panel, panel.view.up)) {
    horizontal(canvas, y_of(panel, tick), area.x, area.x + area.width, {kGridLine});
  }
}

void draw_axes(Canvas& canvas, const Panel& panel) {
  const Rectangle& area = panel.area;
  const double bottom = area.y + area.height;
  canvas.frame({crisp(area.x), crisp(area.y), std::round(area.width), std::round(area.height)}, {kFrame});
  const TextStyle label{14.0, kMutedInk};
  TextStyle below = label;
  below.align = Align::kCenter;
  for (const double tick : ticks_along(panel, panel.view.right)) {
    vertical(canvas, x_of(panel, tick), bottom, bottom + 6.0, {kFrame});
    canvas.text({x_of(panel, tick), bottom + 23.0}, tick_label(tick), below);
  }
  TextStyle beside = label;
  beside.align = Align::kRight;
  for (const double tick : ticks_along(panel, panel.view.up)) {
    horizontal(canvas, y_of(panel, tick), area.x - 6.0, area.x, {kFrame});
    canvas.text({area.x - 12.0, y_of(panel, tick) + 5.0}, tick_label(tick), beside);
  }
  below.size = 15.0;
  below.color = kInk;
  canvas.text({area.x + area.width / 2, bottom + 47.0},
              kAxisNames[static_cast<std::size_t>(panel.view.right)], below);
  below.upward = true;
  canvas.text({area.x - 56.0, area.y + area.height / 2}, kAxisNames[static_cast<std::size_t>(panel.view.up)],
              below);
  canvas.text({area.x, area.y - 11.0}, panel.view.title, {16.0, kInk, true});
}

void draw_region(Canvas& canvas, const Panel& panel, const fields::Shape& shape, const Stroke& stroke) {
  if (const auto* box = std::get_if<fields::BoxShape>(&shape)) {
    frame_box(canvas, panel, box->box, stroke);
  } else if (const auto* sphere = std::get_if<fields::SphereShape>(&shape)) {
    frame_sphere(canvas, panel, *sphere, stroke);
  } else if (const auto triangles = triangles_of(std::array{ObstacleSpec{shape, {}}}, panel.bounds);
             triangles && !triangles->empty()) {
    Box around{triangles->front()[0], triangles->front()[0]};
    for (const Triangle& triangle : *triangles) {
      for (const glm::vec3& p : triangle) {
        around = {glm::min(around.min, p), glm::max(around.max, p)};
      }
    }
    frame_box(canvas, panel, around, stroke);
  }
}

void draw_paths(Canvas& canvas, const Panel& panel, std::span<const PathSampler::Row> rows) {
  if (rows.empty()) {
    return;
  }
  const std::size_t paths = rows.front().positions.size();
  // About as many pieces as the eye can tell colours, and no more than can be drawn in a few seconds.
  const std::size_t piece = std::max<std::size_t>(1, (rows.size() + 99) / 100);
  const double end = std::max(rows.back().time_s, 1e-9);
  for (std::size_t first = 0; first + 1 < rows.size(); first += piece) {
    const auto part = rows.subspan(first, std::min(piece + 1, rows.size() - first));
    const Stroke stroke{time_color(part.back().time_s / end), 1.4, path_alpha(paths)};
    for (std::size_t path = 0; path < paths; ++path) {
      draw_piece(canvas, panel, part, path, stroke);
    }
  }
  for (std::size_t path = 0; path < paths; ++path) {
    if (const glm::vec3 last = rows.back().positions[path]; finite(last)) {
      canvas.dot(panel.at(last), 3.1, time_color(1.0), {kInk, 0.9, 0.75});
    }
  }
}

}  // namespace mayfly::record
