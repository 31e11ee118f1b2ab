// Colours of a figure.
#pragma once

namespace mayfly::record {

struct Color {  // sRGB, 0…1
  double red = 0.0, green = 0.0, blue = 0.0;
};

// Time as colour: from deep blue through magenta to amber. Even steps look even, because lightness, chroma
// and hue run straight in OKLCh (Björn Ottosson, "A perceptual color space for image processing", 2020);
// `fraction` is clamped.
Color time_color(double fraction);

inline constexpr Color kPaper{1.0, 1.0, 1.0};
inline constexpr Color kInk{0.13, 0.15, 0.19};
inline constexpr Color kMutedInk{0.42, 0.45, 0.50};
inline constexpr Color kFrame{0.72, 0.74, 0.77};
inline constexpr Color kGridLine{0.93, 0.935, 0.945};
inline constexpr Color kGoal{0.07, 0.55, 0.30};
inline constexpr Color kStart{0.20, 0.32, 0.52};
inline constexpr Color kBad{0.76, 0.16, 0.16};

}  // namespace mayfly::record
