#include "record/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "record/chart_scale.hpp"

namespace mayfly::record {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> labels(const ChartScale& scale, double length = 500.0) {
  std::vector<std::string> texts;
  for (const Tick& tick : scale.ticks(length, 60.0)) {
    if (!tick.label.empty()) {
      texts.push_back(tick.label);
    }
  }
  return texts;
}

TEST(ChartScale, RunsFromLeastToMost) {
  const ChartScale straight(-2, 6, false);
  EXPECT_DOUBLE_EQ(straight.fraction(-2), 0);
  EXPECT_DOUBLE_EQ(straight.fraction(6), 1);
  EXPECT_DOUBLE_EQ(straight.fraction(0), 0.25);
  const ChartScale decades(1, 1e4, true);
  EXPECT_DOUBLE_EQ(decades.fraction(1), 0);
  EXPECT_DOUBLE_EQ(decades.fraction(100), 0.5);
  EXPECT_DOUBLE_EQ(decades.fraction(1e4), 1);
}

TEST(ChartScale, HasRoundTicks) {
  EXPECT_THAT(labels(ChartScale(0, 10, false)), testing::ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_THAT(labels(ChartScale(1000, 1e6, true)), testing::ElementsAre("1000", "10⁴", "10⁵", "10⁶"));
  EXPECT_THAT(labels(ChartScale(1, 60, true)), testing::ElementsAre("1", "2", "5", "10", "20", "50"));
  EXPECT_THAT(labels(ChartScale(1e-5, 1e-3, true)), testing::Contains("10⁻⁵"));
}

TEST(ChartScale, TicksLieWithinTheAxis) {
  for (const bool logarithmic : {false, true}) {
    for (const auto& [least, most] : {std::pair{0.37, 0.92}, std::pair{3.0, 4e7}, std::pair{1e-30, 1e30}}) {
      const ChartScale scale(least, most, logarithmic);
      EXPECT_LE(scale.ticks(500, 60).size(), 120U);
      for (const Tick& tick : scale.ticks(500, 60)) {
        EXPECT_GE(scale.fraction(tick.value), -1e-6);
        EXPECT_LE(scale.fraction(tick.value), 1 + 1e-6);
      }
    }
  }
}

TEST(ChartScale, MakesARangeWhereThereIsNone) {
  for (const bool logarithmic : {false, true}) {
    for (const double value : {0.0, 5.0, -3.0, kNan, kInfinity, -kInfinity}) {
      const ChartScale scale(value, value, logarithmic);
      EXPECT_LT(scale.least(), scale.most()) << value;
      EXPECT_TRUE(std::isfinite(scale.fraction(scale.most()))) << value;
    }
    EXPECT_FALSE(ChartScale(1, 2, logarithmic).shows(kNan));
  }
  EXPECT_FALSE(ChartScale(1, 2, true).shows(0.0));
}

std::string drawn(const Chart& chart) {
  auto canvas = Canvas::create(600, 400);
  draw_chart(*canvas, {0, 0, 600, 400}, chart);
  return canvas->png().value();
}

Chart chart_of(std::vector<glm::dvec2> points) {
  Chart chart{"title", {"x"}, {"y"}, {}, {}, false};
  chart.series.push_back({"data", std::move(points), {}, 3.0});
  return chart;
}

TEST(Chart, DrawsNothingOnePointAndNonsense) {
  for (const bool logarithmic : {false, true}) {
    for (const auto& points : std::vector<std::vector<glm::dvec2>>{
             {}, {{1, 1}}, {{1, kNan}, {kInfinity, 2}, {-1, -1}}, {{1, 1}, {2, kNan}, {3, 4}, {4, 3}}}) {
      Chart chart = chart_of(points);
      chart.x.logarithmic = chart.y.logarithmic = logarithmic;
      chart.same_scale = !logarithmic;
      EXPECT_THAT(drawn(chart), testing::StartsWith("\x89PNG"));
    }
  }
  EXPECT_THAT(drawn(Chart{}), testing::StartsWith("\x89PNG"));
}

TEST(Chart, ShowsItsData) {
  const std::vector<glm::dvec2> line{{0, 0}, {1, 2}, {2, 1}};
  std::vector<glm::dvec2> broken = line;
  broken[1].y = kNan;
  EXPECT_NE(drawn(chart_of(line)), drawn(chart_of(broken)));
  Chart with_patch = chart_of(line);
  with_patch.patches.push_back({{0.5, 0.5}, {1, 1}, kFrame, false});
  EXPECT_NE(drawn(chart_of(line)), drawn(with_patch));
}

TEST(BarChart, DrawsNothingNonsenseAndReferences) {
  auto canvas = Canvas::create(600, 400);
  draw_bars(*canvas, {0, 0, 600, 400}, {});
  const std::string empty = canvas->png().value();
  BarChart chart{"title", {"share"}, {}, 0.5};
  chart.bars = {{"a", 1.0, glm::dvec2(0.8, 1.2)}, {"b\nsecond line", kNan}, {"c", -2.0}, {"", 1e300}};
  draw_bars(*canvas, {0, 0, 600, 400}, chart);
  EXPECT_NE(canvas->png().value(), empty);
}

}  // namespace
}  // namespace mayfly::record
