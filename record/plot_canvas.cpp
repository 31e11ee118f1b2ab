#include "record/plot_canvas.hpp"

#include <cairo.h>

#include <cmath>
#include <cstring>
#include <numbers>

namespace mayfly::record {

struct Canvas::State {
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;
  ~State() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }

  void set(const Color& color, double alpha) {
    cairo_set_source_rgba(cairo, color.red, color.green, color.blue, alpha);
  }
  void stroke(const Stroke& stroke) {
    set(stroke.color, stroke.alpha);
    cairo_set_line_width(cairo, stroke.width);
    cairo_set_dash(cairo, &stroke.dash, stroke.dash > 0.0 ? 1 : 0, 0.0);
    cairo_stroke(cairo);
  }
  void font(const TextStyle& style) {
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, style.size);
  }
};

namespace {

tl::unexpected<Error> cairo_error(cairo_status_t status) {
  return fail(Cause::kEnvironment, std::string("cannot draw the plot: ") + cairo_status_to_string(status));
}

}  // namespace

Result<Canvas> Canvas::create(double width, double height) {
  auto state = std::make_unique<State>();
  state->surface =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height));
  state->cairo = cairo_create(state->surface);
  if (const auto status = cairo_status(state->cairo); status != CAIRO_STATUS_SUCCESS) {
    return cairo_error(status);
  }
  cairo_set_line_join(state->cairo, CAIRO_LINE_JOIN_ROUND);
  Canvas canvas(std::move(state));
  canvas.fill({0.0, 0.0, width, height}, kPaper);
  return canvas;
}

Canvas::Canvas(std::unique_ptr<State> state) noexcept : state_(std::move(state)) {}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

void Canvas::fill(const Rectangle& area, const Color& color) {
  state_->set(color, 1.0);
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  cairo_fill(state_->cairo);
}

void Canvas::frame(const Rectangle& area, const Stroke& stroke) {
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  state_->stroke(stroke);
}

void Canvas::line(std::span<const glm::dvec2> points, const Stroke& stroke) {
  for (const glm::dvec2& point : points) {
    cairo_line_to(state_->cairo, point.x, point.y);
  }
  state_->stroke(stroke);
}

void Canvas::dot(glm::dvec2 center, double radius, const Color& color, const Stroke& ring) {
  cairo_new_sub_path(state_->cairo);
  cairo_arc(state_->cairo, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
  state_->set(color, 1.0);
  cairo_fill_preserve(state_->cairo);
  state_->stroke(ring);
}

void Canvas::image(const Relief& relief, const Rectangle& area) {
  cairo_surface_t* picture = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, relief.width, relief.height);
  if (cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS) {
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(picture));
    const auto row = static_cast<std::size_t>(relief.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(relief.height); ++y) {
      std::memcpy(cairo_image_surface_get_data(picture) + y * stride, relief.pixels.data() + y * row,
                  row * sizeof(std::uint32_t));
    }
    cairo_surface_mark_dirty(picture);
    clip(area);
    cairo_translate(state_->cairo, area.x, area.y);
    cairo_scale(state_->cairo, 1.0 / kReliefDetail, 1.0 / kReliefDetail);
    cairo_set_source_surface(state_->cairo, picture, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(state_->cairo), CAIRO_FILTER_GOOD);
    cairo_paint(state_->cairo);
    unclip();
  }
  cairo_surface_destroy(picture);
}

double Canvas::text_width(std::string_view text, const TextStyle& style) {
  state_->font(style);
  cairo_text_extents_t extents{};
  cairo_text_extents(state_->cairo, std::string(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(glm::dvec2 at, std::string_view text, const TextStyle& style) {
  const double width = text_width(text, style);
  const double shift = style.align == Align::kLeft ? 0.0 : style.align == Align::kCenter ? width / 2 : width;
  cairo_save(state_->cairo);
  cairo_translate(state_->cairo, at.x, at.y);
  cairo_rotate(state_->cairo, style.upward ? -std::numbers::pi / 2 : 0.0);
  cairo_move_to(state_->cairo, -shift, 0.0);
  state_->set(style.color, 1.0);
  cairo_show_text(state_->cairo, std::string(text).c_str());
  cairo_restore(state_->cairo);
  cairo_new_path(state_->cairo);
}

void Canvas::clip(const Rectangle& area) {
  cairo_save(state_->cairo);
  cairo_rectangle(state_->cairo, area.x, area.y, area.width, area.height);
  cairo_clip(state_->cairo);
}

void Canvas::unclip() {
  cairo_restore(state_->cairo);
}

Result<std::string> Canvas::png() const {
  std::string bytes;
  const auto append = [](void* closure, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  if (const auto status = cairo_surface_write_to_png_stream(state_->surface, append, &bytes);
      status != CAIRO_STATUS_SUCCESS) {
    return cairo_error(status);
  }
  return bytes;
}

}  // namespace mayfly::record
