#include <array>
#include <string>

#include "bench/noise/report.hpp"
#include "record/chart.hpp"

namespace mayfly::bench {
namespace {

using record::BarChart;
using record::Canvas;
using record::Chart;
using record::Color;
using record::Series;
using record::series_color;

constexpr double kWidth = 1640.0;
constexpr double kHeight = 1850.0;
constexpr double kMargin = 20.0;
constexpr double kInner = kWidth - 2.0 * kMargin;

Color color_of(NoiseKind noise) {
  switch (noise) {
    case NoiseKind::kCurl:
      return series_color(0);
    case NoiseKind::kPerlin:
      return series_color(1);
    case NoiseKind::kWhite:
      return series_color(2);
    default:
      return series_color(6);
  }
}

std::string title_of(const VariantResult& variant) {
  const std::string model = variant.model == SteeredBy::kPath    ? "our path field"
                            : variant.model == SteeredBy::kBoids ? "Boids"
                                                                 : "compressible crowd";
  return model + ", " + std::string(name_of(variant.noise)) + " noise";
}

// From above: y to the right, −x up.
glm::dvec2 on_map(glm::vec3 p) {
  return {static_cast<double>(p.y), -static_cast<double>(p.x)};
}

// The rectangle of the world that a map shows, in its own axes, and every how many rows of the paths.
struct Window {
  glm::dvec2 least, most;
  std::size_t step;
};
constexpr Window kWhole{{0.0, -52.0}, {112.0, -8.0}, 5};
constexpr Window kCloseUp{{18.0, -34.5}, {32.0, -29.0}, 1};

Chart map_of(const VariantResult& variant, const Window& window, std::string title) {
  Chart map{std::move(title),
            {"y (m)", false, window.least.x, window.most.x},
            {"−x (m)", false, window.least.y, window.most.y}};
  map.same_scale = true;
  for (const double x : {-24.0, -60.0}) {
    map.patches.push_back({{48.0, x}, {64.0, x + 24.0}, record::kFrame});
  }
  map.patches.push_back({{100.0, -40.0}, {110.0, -20.0}, record::kGoal, true});
  map.patches.push_back({{4.0, -40.0}, {14.0, -20.0}, record::kStart, true});
  for (std::size_t path = 0; path < variant.paths; ++path) {
    Series series{"", {}, {color_of(variant.noise), 0.9, 0.5}};
    for (std::size_t i = path; i < variant.path_rows.size(); i += window.step * variant.paths) {
      series.points.push_back(on_map(variant.path_rows[i]));
    }
    map.series.push_back(std::move(series));
  }
  Series ends{"", {}, {record::kInk, 0.0}, 2.4};
  for (const glm::vec3& end : variant.ends) {
    ends.points.push_back(on_map(end));
  }
  map.series.push_back(std::move(ends));
  return map;
}

Chart curves_of(const NoiseComparison& comparison, bool turning) {
  Chart chart;
  chart.title = turning ? "Spectrum of turning, our path field" : "Clumping over time, our path field";
  chart.x = turning ? record::Axis{"frequency (Hz)", true} : record::Axis{"time (s)"};
  chart.y =
      turning ? record::Axis{"share of the power a Hz", true, 1e-6} : record::Axis{"clumping (1: chance)"};
  for (const VariantResult& variant : comparison.variants) {
    // Without noise agents fly straight on: their turning is rounding.
    if (variant.model == SteeredBy::kPath && !(turning && variant.noise == NoiseKind::kNone)) {
      chart.series.push_back({std::string(name_of(variant.noise)),
                              turning ? variant.curves.turning : variant.curves.clumping,
                              {color_of(variant.noise), 2.0}});
    }
  }
  return chart;
}

BarChart bars_of(const NoiseComparison& comparison, std::string title, std::string axis,
                 double Measures::*member) {
  BarChart chart{std::move(title), {std::move(axis)}};
  for (const VariantResult& variant : comparison.variants) {
    chart.bars.push_back({std::string(name_of(variant.model)) + "\n" + std::string(name_of(variant.noise)),
                          variant.mean(member), glm::dvec2(variant.least(member), variant.most(member)),
                          color_of(variant.noise)});
  }
  return chart;
}

void draw_maps(Canvas& canvas, double y, double height, const NoiseComparison& comparison, bool ours,
               const Window& window) {
  std::vector<const VariantResult*> shown;
  for (const VariantResult& variant : comparison.variants) {
    if ((variant.model == SteeredBy::kPath) == ours && variant.noise != NoiseKind::kNone) {
      shown.push_back(&variant);
    }
  }
  const double width = kInner / static_cast<double>(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string title =
        window.step == 1 ? "Closer: " + std::string(name_of(shown[i]->noise)) : title_of(*shown[i]);
    record::draw_chart(canvas, {kMargin + static_cast<double>(i) * width, y, width, height},
                       map_of(*shown[i], window, title));
  }
}

}  // namespace

Result<std::string> draw_figure(const NoiseComparison& comparison) {
  auto canvas = Canvas::create(kWidth, kHeight);
  if (!canvas) {
    return fail(std::move(canvas.error()));
  }
  canvas->text({kMargin + 12.0, 46.0}, "Noises compared", {30.0, record::kInk, true});
  canvas->text(
      {kMargin + 12.0, 74.0},
      "Two blocks, " + std::to_string(comparison.plan.agents) +
          " agents, equally fast noise, no minimum distance enforced. Dots: where agents are at the end.",
      {16.0, record::kMutedInk});
  draw_maps(*canvas, 95.0, 275.0, comparison, true, kWhole);
  draw_maps(*canvas, 380.0, 275.0, comparison, true, kCloseUp);
  draw_maps(*canvas, 670.0, 230.0, comparison, false, kWhole);
  const double half = kInner / 2.0;
  record::draw_chart(*canvas, {kMargin, 930.0, half, 440.0}, curves_of(comparison, false));
  record::draw_chart(*canvas, {kMargin + half, 930.0, half, 440.0}, curves_of(comparison, true));
  record::draw_bars(*canvas, {kMargin, 1400.0, half, 430.0},
                    bars_of(comparison, "Clumping in the second half of the flight", "clumping (1: chance)",
                            &Measures::clumping));
  record::draw_bars(
      *canvas, {kMargin + half, 1400.0, half, 430.0},
      bars_of(comparison, "Agents nearer than d_min = 0.2 m to another", "share", &Measures::near_share));
  return canvas->png();
}

}  // namespace mayfly::bench
