// What was compared, for people and for programs.
#pragma once

#include <string>

#include "bench/noise/comparison.hpp"

namespace mayfly::bench {

// The table, a line for each variant, and the verdicts.
std::string to_text(const NoiseComparison& comparison);
std::string to_json(const NoiseComparison& comparison);
// A PNG: paths of the variants side by side, clumping over time, spectra, bars.
Result<std::string> draw_figure(const NoiseComparison& comparison);

}  // namespace mayfly::bench
