#include "record/plot_colors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mayfly::record {
namespace {

struct LinearColor {
  double red, green, blue;
  bool inside() const {
    const auto fits = [](double c) { return c >= -1e-4 && c <= 1.0 + 1e-4; };
    return fits(red) && fits(green) && fits(blue);
  }
};

LinearColor from_oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(hue);
  const double b = chroma * std::sin(hue);
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

double encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

}  // namespace

Color time_color(double fraction) {
  const double t = std::clamp(fraction, 0.0, 1.0);
  const double lightness = std::lerp(0.36, 0.79, t);
  const double hue = std::lerp(268.0, 438.0, t) * std::numbers::pi / 180.0;
  // As colourful as the screen can show at this lightness and hue, up to a limit.
  double chroma = 0.19;
  while (chroma > 0.0 && !from_oklch(lightness, chroma, hue).inside()) {
    chroma -= 0.005;
  }
  const LinearColor color = from_oklch(lightness, chroma, hue);
  return {encoded(color.red), encoded(color.green), encoded(color.blue)};
}

}  // namespace mayfly::record
