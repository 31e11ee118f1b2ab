#include "record/plot_relief.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mayfly::record {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();
constexpr double kShadow = 0.70;  // grey levels
constexpr double kLight = 0.93;
constexpr double kContour = 0.47;
// Light from the upper left, from behind the viewer's shoulder: right, up, toward the viewer.
const glm::vec3 kLightFrom = glm::normalize(glm::vec3(-0.45F, 0.55F, 0.75F));

struct Screen {
  const Panel& panel;
  int width, height;
  std::vector<float> depth;
  std::vector<float> shade;

  explicit Screen(const Panel& p)
      : panel(p),
        width(std::max(1, static_cast<int>(std::ceil(p.area.width * kReliefDetail)))),
        height(std::max(1, static_cast<int>(std::ceil(p.area.height * kReliefDetail)))),
        depth(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNothing),
        shade(depth.size(), 0.0F) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  glm::vec3 project(glm::vec3 world) const {
    const glm::dvec2 at = (panel.at(world) - glm::dvec2(panel.area.x, panel.area.y)) * double{kReliefDetail};
    return {at.x, at.y, panel.depth(world)};
  }
  void draw(const Triangle& triangle);
};

// Depth over the pixel's centre, by edge functions; the nearest to the viewer wins.
void Screen::draw(const Triangle& triangle) {
  const std::array<glm::vec3, 3> p{project(triangle[0]), project(triangle[1]), project(triangle[2])};
  const auto cross = [](glm::vec3 a, glm::vec3 b, double x, double y) {
    return (double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x);
  };
  const double area = cross(p[0], p[1], p[2].x, p[2].y);
  if (std::abs(area) < 1e-9) {
    return;  // seen edge-on
  }
  const View& view = panel.view;
  const glm::vec3 n = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  glm::vec3 seen(n[view.right], view.up_sign * n[view.up], view.toward_sign * n[view.toward]);
  seen *= (seen.z < 0 ? -1.0F : 1.0F) / glm::length(seen);
  const float light = std::max(0.0F, glm::dot(seen, kLightFrom));

  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const auto pixel = [](float at, int end) {
    return static_cast<int>(std::clamp(at, 0.0F, static_cast<float>(end)));
  };
  for (int y = pixel(top, height); y < std::min(height, pixel(bottom, height) + 1); ++y) {
    for (int x = pixel(left, width); x < std::min(width, pixel(right, width) + 1); ++x) {
      const double a = cross(p[1], p[2], x + 0.5, y + 0.5) / area;
      const double b = cross(p[2], p[0], x + 0.5, y + 0.5) / area;
      const double c = 1.0 - a - b;
      if (a < 0.0 || b < 0.0 || c < 0.0) {
        continue;
      }
      const auto z = static_cast<float>(a * p[0].z + b * p[1].z + c * p[2].z);
      if (z > depth[index(x, y)]) {
        depth[index(x, y)] = z;
        shade[index(x, y)] = light;
      }
    }
  }
}

// An outline runs along the inside of each silhouette, and where one part stands clearly in front of another.
bool on_contour(const Screen& screen, int x, int y, float step) {
  const float here = screen.depth[screen.index(x, y)];
  for (int dy = -kReliefDetail; dy <= kReliefDetail; ++dy) {
    for (int dx = -kReliefDetail; dx <= kReliefDetail; ++dx) {
      const int nx = x + dx;
      const int ny = y + dy;
      // A solid that goes on beyond the world's edge has no contour there.
      if (dx * dx + dy * dy > kReliefDetail * kReliefDetail || nx < 0 || ny < 0 || nx >= screen.width ||
          ny >= screen.height) {
        continue;
      }
      if (here - screen.depth[screen.index(nx, ny)] > step) {
        return true;
      }
    }
  }
  return false;
}

std::uint32_t opaque(double grey) {
  const auto level = static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(grey, 0.0, 1.0)));
  // A touch of blue in the shadows keeps grey from looking dirty beside the colours.
  const std::uint32_t blue = std::min<std::uint32_t>(255U, level + 4U);
  return 0xFF000000U | level << 16U | level << 8U | blue;
}

}  // namespace

Relief draw_relief(std::span<const Triangle> triangles, const Panel& panel) {
  Screen screen(panel);
  for (const Triangle& triangle : triangles) {
    screen.draw(triangle);
  }
  const glm::vec3 size = panel.bounds.max - panel.bounds.min;
  const float step = 0.04F * std::max({size.x, size.y, size.z});

  Relief relief{screen.width, screen.height, std::vector<std::uint32_t>(screen.depth.size(), 0U)};
  for (int y = 0; y < screen.height; ++y) {
    for (int x = 0; x < screen.width; ++x) {
      const std::size_t i = screen.index(x, y);
      if (screen.depth[i] == kNothing) {
        continue;
      }
      const double lit = std::lerp(kShadow, kLight, double{screen.shade[i]});
      relief.pixels[i] = opaque(on_contour(screen, x, y, step) ? kContour : lit);
    }
  }
  return relief;
}

}  // namespace mayfly::record
