// Where things are on a figure of a world's top and side view.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "core/grid.hpp"

namespace mayfly::record {

// A direction to look at the world along one of its axes.
struct View {
  int right = 0;  // world axis that runs to the right: 0 x, 1 y, 2 z
  int up = 1;     // world axis that runs up, or down where up_sign is -1
  float up_sign = 1.0F;
  int toward = 2;  // world axis along which the viewer stands
  float toward_sign = 1.0F;
  std::string_view title;
};

struct Rectangle {  // px, y down
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

struct Panel {
  View view;
  Box bounds;  // m
  Rectangle area;
  double scale = 1.0;  // px a metre, the same for both axes and all panels

  // px on the figure; depth in m grows toward the viewer.
  glm::dvec2 at(glm::vec3 world) const;
  double depth(glm::vec3 world) const { return view.toward_sign * world[view.toward]; }
};

struct Layout {
  double width = 0.0, height = 0.0;  // px
  Rectangle header;
  std::array<Panel, 2> panels;  // top, side
};

// The longer horizontal axis of the world runs to the right. The side view is what someone sees who stands at
// the lower edge of the top view: neither is mirrored. One above the other, or beside each other where that
// would be too tall.
Layout lay_out(const Box& bounds);

}  // namespace mayfly::record
