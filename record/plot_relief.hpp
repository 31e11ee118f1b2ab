// Solids as a picture: what of them a viewer sees, lit softly, with contours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "record/plot_layout.hpp"
#include "record/plot_solids.hpp"

namespace mayfly::record {

struct Relief {
  int width = 0, height = 0;  // px: kReliefDetail of them for one px of the figure
  std::vector<std::uint32_t>
      pixels;  // premultiplied ARGB, row by row from the top; transparent where nothing is
};
inline constexpr int kReliefDetail = 2;

Relief draw_relief(std::span<const Triangle> triangles, const Panel& panel);

}  // namespace mayfly::record
