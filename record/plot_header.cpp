#include "record/plot_header.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "record/grouped_digits.hpp"

namespace mayfly::record {
namespace {

std::string grouped(std::uint64_t number) {
  return grouped_digits(number, "\u202F");
}

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string optional_text(const char* format, const std::optional<double>& value) {
  return value ? formatted(format, *value) : "not measured";
}

struct Figure {
  std::string name;
  std::string value;
  Color color = kInk;
};

std::array<Figure, 5> figures_of(const Summary& s) {
  const bool unreached = s.reached_fraction && *s.reached_fraction < 0.99;
  const bool entered = s.penetrations && *s.penetrations > 0;
  return {Figure{"reached the goal",
                 optional_text("%.4g %%",
                               s.reached_fraction ? std::optional(100 * *s.reached_fraction) : std::nullopt),
                 unreached ? kBad : kInk},
          Figure{"minimum separation", optional_text("%.3f m", s.min_separation_m)},
          Figure{"inside obstacles", s.penetrations ? grouped(*s.penetrations) : "not measured",
                 entered ? kBad : kInk},
          Figure{"moved by MDE", optional_text("%.3g %% a tick", s.mde_percent)},
          Figure{"fastest", optional_text("%.2f m/s", s.max_speed_mps)}};
}

void draw_figures(Canvas& canvas, glm::dvec2 at, const Summary& summary) {
  for (const Figure& figure : figures_of(summary)) {
    const TextStyle name{14.0, kMutedInk};
    const TextStyle value{21.0, figure.color, true};
    canvas.text(at, figure.name, name);
    canvas.text({at.x, at.y + 28.0}, figure.value, value);
    at.x += std::max(canvas.text_width(figure.name, name), canvas.text_width(figure.value, value)) + 46.0;
  }
}

void draw_time_bar(Canvas& canvas, const Rectangle& bar, double end_s) {
  constexpr int kSteps = 130;
  for (int i = 0; i < kSteps; ++i) {
    const double left = std::floor(bar.x + bar.width * i / kSteps);
    const double right = std::floor(bar.x + bar.width * (i + 1) / kSteps);
    canvas.fill({left, bar.y, right - left, bar.height}, time_color((i + 0.5) / kSteps));
  }
  const double below = bar.y + bar.height + 19.0;
  canvas.text({bar.x, below}, "0 s", {14.0, kMutedInk});
  canvas.text({bar.x + bar.width / 2, below}, "time", {14.0, kMutedInk, false, Align::kCenter});
  canvas.text({bar.x + bar.width, below}, formatted("%.3g s", end_s),
              {14.0, kMutedInk, false, Align::kRight});
}

void draw_keys(Canvas& canvas, const Rectangle& bar, double y) {
  const TextStyle label{14.0, kInk};
  canvas.frame({bar.x + 0.5, y - 11.5, 22.0, 13.0}, {kStart, 1.6, 1.0, 4.0});
  canvas.text({bar.x + 30.0, y}, "start", label);
  canvas.frame({bar.x + 96.5, y - 11.5, 22.0, 13.0}, {kGoal, 2.2});
  canvas.text({bar.x + 126.0, y}, "goal", label);
  canvas.dot({bar.x + 196.0, y - 5.0}, 4.0, time_color(1.0), {kInk, 0.9, 0.75});
  canvas.text({bar.x + 207.0, y}, "end", label);
}

}  // namespace

void draw_header(Canvas& canvas, const Rectangle& area, const Summary& s, double end_s) {
  canvas.text({area.x, area.y + 28.0}, s.scenario, {34.0, kInk, true});
  if (s.all_infeasible_s) {
    const double behind = area.x + canvas.text_width(s.scenario, {34.0, kInk, true}) + 28.0;
    canvas.text({behind, area.y + 28.0}, formatted("every agent infeasible at %.4g s", *s.all_infeasible_s),
                {17.0, kBad, true});
  }
  const std::string what = grouped(s.agents) + (s.agents == 1 ? " agent" : " agents") + "   ·   seed " +
                           std::to_string(s.seed) + "   ·   " + s.engine + " engine   ·   HAL " + s.hal +
                           "   ·   " + formatted("%.4g s flown", s.simulated_s);
  canvas.text({area.x, area.y + 60.0}, what, {17.0, kMutedInk});
  draw_figures(canvas, {area.x, area.y + 102.0}, s);
  const Rectangle bar{area.x + area.width - 250.0, area.y + 6.0, 250.0, 15.0};
  draw_time_bar(canvas, bar, end_s);
  draw_keys(canvas, bar, area.y + 74.0);
}

}  // namespace mayfly::record
