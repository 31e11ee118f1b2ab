// What a benchmark measured: rows beside their bounds and baselines, and curves; for people, for programs and
// as a figure.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace mayfly::bench {

struct Row {
  std::string key;   // in the JSON
  std::string what;  // for people
  double value = 0.0;
  std::string unit;
  std::optional<double> wanted{};
  bool less_is_better = true;
  std::string baseline{};                  // whose value, in the same unit, stands beside ours
  std::optional<double> baseline_value{};  // measured in this run

  // How many times better than the baseline.
  std::optional<double> ratio() const {
    if (!baseline_value) {
      return std::nullopt;
    }
    return less_is_better ? *baseline_value / value : value / *baseline_value;
  }
  bool holds() const { return !wanted || (less_is_better ? value <= *wanted : value >= *wanted); }
};

// How one quantity grows with another.
struct Curve {
  std::string key, title, x_name, y_name;
  std::vector<std::pair<std::string, std::vector<glm::dvec2>>> lines;  // by name
  bool logarithmic = true;                                             // both axes of its figure
};

struct Report {
  std::string bench;  // its name
  std::string title;  // for people
  std::vector<Row> rows;
  std::vector<Curve> curves;
  double took_s = 0.0;
};

std::string to_text(const Report& report);
std::string to_json(const Report& report);
// A PNG with every curve.
Result<std::string> draw_figure(const Report& report);

}  // namespace mayfly::bench
