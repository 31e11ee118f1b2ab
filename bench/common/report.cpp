#include "bench/common/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "record/chart.hpp"

namespace mayfly::bench {
namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

std::string wanted_text(const Row& row) {
  return row.wanted ? fmt::format("{} {:g}", row.less_is_better ? "<=" : ">=", *row.wanted) : std::string();
}

std::string baseline_text(const Row& row) {
  if (!row.baseline_value) {
    return {};
  }
  return fmt::format("{:.1f} x {} ({:.4g})", *row.ratio(), row.baseline, *row.baseline_value);
}

Json row_json(const Row& row) {
  return {{"key", row.key},
          {"what", row.what},
          {"value", number(row.value)},
          {"unit", row.unit},
          {"wanted", number(row.wanted)},
          {"less_is_better", row.less_is_better},
          {"baseline", row.baseline.empty() ? Json() : Json(row.baseline)},
          {"baseline_value", number(row.baseline_value)},
          {"ratio", number(row.ratio())},
          {"holds", row.holds()}};
}

Json curve_json(const Curve& curve) {
  Json json{{"key", curve.key}, {"title", curve.title}, {"x", curve.x_name}, {"y", curve.y_name}};
  for (const auto& [name, points] : curve.lines) {
    for (const glm::dvec2 point : points) {
      json["lines"][name].push_back({point.x, point.y});
    }
  }
  return json;
}

}  // namespace

std::string to_text(const Report& report) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}, {:.0f} s\n\n{:<8} {:<58} {:>10} {:<8} {:<9} {}\n", report.title, report.took_s, "",
                 "", "measured", "", "wanted", "times better than");
  for (const Row& row : report.rows) {
    fmt::format_to(out, "{:<8} {:<58} {:>10.4g} {:<8} {:<9} {}\n",
                   !row.wanted   ? ""
                   : row.holds() ? "holds"
                                 : "DOES NOT",
                   row.what, row.value, row.unit, wanted_text(row), baseline_text(row));
  }
  for (const Curve& curve : report.curves) {
    fmt::format_to(out, "\n{}: {} over {}\n", curve.title, curve.y_name, curve.x_name);
    for (const auto& [name, points] : curve.lines) {
      fmt::format_to(out, "  {:<14}", name);
      for (const glm::dvec2 point : points) {
        fmt::format_to(out, " {:.7g}: {:.4g}", point.x, point.y);
      }
      text += '\n';
    }
  }
  return text;
}

std::string to_json(const Report& report) {
  Json json{
      {"bench", report.bench}, {"took_s", report.took_s}, {"rows", Json::array()}, {"curves", Json::array()}};
  for (const Row& row : report.rows) {
    json["rows"].push_back(row_json(row));
  }
  for (const Curve& curve : report.curves) {
    json["curves"].push_back(curve_json(curve));
  }
  return json.dump(2) + '\n';
}

Result<std::string> draw_figure(const Report& report) {
  constexpr double kWidth = 760.0;
  constexpr double kHeight = 520.0;
  constexpr std::size_t kColumns = 2;
  const std::size_t lines = (report.curves.size() + kColumns - 1) / kColumns;
  auto canvas = record::Canvas::create(kWidth * static_cast<double>(kColumns),
                                       kHeight * static_cast<double>(std::max<std::size_t>(lines, 1)));
  if (!canvas) {
    return fail(std::move(canvas.error()));
  }
  for (std::size_t c = 0; c < report.curves.size(); ++c) {
    const Curve& curve = report.curves[c];
    const std::size_t line = c / kColumns;
    record::Chart chart{.title = curve.title,
                        .x = {.name = curve.x_name, .logarithmic = curve.logarithmic},
                        .y = {.name = curve.y_name, .logarithmic = curve.logarithmic}};
    for (std::size_t n = 0; n < curve.lines.size(); ++n) {
      chart.series.push_back({.name = curve.lines[n].first,
                              .points = curve.lines[n].second,
                              .stroke = {record::series_color(n), 2.2},
                              .dot_radius = 4.0});
    }
    record::draw_chart(
        *canvas,
        {kWidth * static_cast<double>(c % kColumns), kHeight * static_cast<double>(line), kWidth, kHeight},
        chart);
  }
  return canvas->png();
}

}  // namespace mayfly::bench
