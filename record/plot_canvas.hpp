// A picture to draw on.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "record/plot_colors.hpp"
#include "record/plot_layout.hpp"
#include "record/plot_relief.hpp"

namespace mayfly::record {

struct Stroke {
  Color color = kInk;
  double width = 1.0;  // px
  double alpha = 1.0;
  double dash = 0.0;  // px, of strokes and gaps; 0 for a solid line
};

enum class Align { kLeft, kCenter, kRight };

struct TextStyle {
  double size = 15.0;  // px
  Color color = kInk;
  bool bold = false;
  Align align = Align::kLeft;
  bool upward = false;  // turned to read from below
};

// Positions in px, y down, the baseline for text.
class Canvas {
 public:
  // White. Fails where there is no memory for it.
  static Result<Canvas> create(double width, double height);
  Canvas(Canvas&&) noexcept;
  ~Canvas();

  void fill(const Rectangle& area, const Color& color);
  void frame(const Rectangle& area, const Stroke& stroke);
  void line(std::span<const glm::dvec2> points, const Stroke& stroke);
  void dot(glm::dvec2 center, double radius, const Color& color, const Stroke& ring);
  void image(const Relief& relief, const Rectangle& area);
  void text(glm::dvec2 at, std::string_view text, const TextStyle& style);
  double text_width(std::string_view text, const TextStyle& style);

  // What is drawn until unclip() shows only in `area`.
  void clip(const Rectangle& area);
  void unclip();

  Result<std::string> png() const;

 private:
  struct State;
  explicit Canvas(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace mayfly::record
