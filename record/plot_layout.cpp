#include "record/plot_layout.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace mayfly::record {
namespace {

constexpr double kWidth = 1600.0;
constexpr double kHeader = 208.0;
constexpr double kLeft = 92.0;  // room for tick labels and the axis name
constexpr double kRight = 40.0;
constexpr double kAbove = 34.0;      // a panel's title
constexpr double kBelow = 70.0;      // tick labels and axis name below a panel
constexpr double kTallest = 1850.0;  // of the panels together

std::array<View, 2> views_of(const glm::vec3& size) {
  if (size.x >= size.y) {
    return {View{0, 1, 1.0F, 2, 1.0F, "top view"}, View{0, 2, 1.0F, 1, -1.0F, "side view"}};
  }
  return {View{1, 0, -1.0F, 2, 1.0F, "top view"}, View{1, 2, 1.0F, 0, 1.0F, "side view"}};
}

}  // namespace

glm::dvec2 Panel::at(glm::vec3 world) const {
  const double right = world[view.right] - bounds.min[view.right];
  const double up =
      view.up_sign > 0 ? bounds.max[view.up] - world[view.up] : world[view.up] - bounds.min[view.up];
  return {area.x + scale * right, area.y + scale * up};
}

Layout lay_out(const Box& bounds) {
  const glm::dvec3 size = glm::max(bounds.max - bounds.min, glm::vec3(1e-3F));
  const auto views = views_of(size);
  const double length = size[views[0].right];
  const std::array<double, 2> heights{size[views[0].up], size[views[1].up]};

  const double stacked_scale = (kWidth - kLeft - kRight) / length;
  const bool stacked = stacked_scale * (heights[0] + heights[1]) <= kTallest;
  const double beside_scale =
      std::min((kWidth - 2 * kLeft - 2 * kRight) / (2 * length), kTallest / std::max(heights[0], heights[1]));
  const double scale = stacked ? stacked_scale : beside_scale;
  const double left_of_second = stacked ? kLeft : kWidth / 2 + kLeft;

  Layout layout;
  layout.width = kWidth;
  layout.header = {40.0, 36.0, kWidth - 80.0, kHeader - 36.0};
  double y = kHeader + kAbove;
  for (std::size_t i = 0; i < 2; ++i) {
    const double height = heights[i] * scale;
    layout.panels[i] = {
        views[i], bounds, {i == 0 ? kLeft : left_of_second, y, length * scale, height}, scale};
    layout.height = std::max(layout.height, y + height + kBelow);
    y += stacked ? height + kBelow + kAbove : 0.0;
  }
  layout.height = std::ceil(layout.height);
  return layout;
}

}  // namespace mayfly::record
